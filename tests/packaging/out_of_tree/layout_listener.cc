// A node of somebody else: listens to the layout of the running world. It says which layouts it
// understands, and ends at once where there is no master.
#include <latticeworld/Layout.h>
#include <ros/ros.h>

#include <cstdlib>
#include <iostream>

namespace {

void TellLayout(const latticeworld::Layout& layout) { std::cout << layout.world_id << std::endl; }

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "layout_listener", ros::init_options::NoSigintHandler);
  std::cout << ros::message_traits::datatype<latticeworld::Layout>() << " "
            << ros::message_traits::md5sum<latticeworld::Layout>() << std::endl;
  if (!ros::master::check()) return EXIT_SUCCESS;
  ros::NodeHandle node;
  const ros::Subscriber listener = node.subscribe("world/layout", 1, TellLayout);
  ros::spin();
  return EXIT_SUCCESS;
}
