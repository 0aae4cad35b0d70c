// rviz_displays CONFIG PICTURE SECONDS: loads an rviz configuration as rviz does, waits until every
// display that is switched on says that it is Ok and something is to be seen, and takes a picture
// of the window. Prints each display's status. Exit status: 0 when all is so, 1 when it is not
// after so many seconds.

#include <ros/ros.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/properties/status_list.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QPixmap>
#include <QScreen>
#include <QTimer>
#include <cstdlib>
#include <iostream>
#include <set>
#include <sstream>
#include <string>

namespace {

constexpr int kLook_ms = 200;
// So many looks in a row must find all Ok, for what is shown comes and goes at the start.
constexpr int kLooks = 10;
// The buttons and the background alone have fewer colours within the middle of the window.
constexpr std::size_t kColours = 8;

const char* Word(rviz::StatusProperty::Level level) {
  switch (level) {
    case rviz::StatusProperty::Ok:
      return "Ok";
    case rviz::StatusProperty::Warn:
      return "Warn";
    case rviz::StatusProperty::Error:
      return "Error";
  }
  return "?";
}

// Whether what is switched on in a group is Ok; a line for each display to `text`.
bool AllOk(const rviz::DisplayGroup& group, std::ostream* text) {
  bool ok = true;
  for (int i = 0; i < group.numDisplays(); ++i) {
    const rviz::Display* display = group.getDisplayAt(i);
    if (!display->isEnabled()) continue;
    if (const auto* inner = dynamic_cast<const rviz::DisplayGroup*>(display))
      ok = AllOk(*inner, text) && ok;
    // One whose plugin is missing has a status, too: that it is missing.
    bool has_status = false;
    for (int child = 0; child < display->numChildren(); ++child) {
      const auto* status = dynamic_cast<const rviz::StatusList*>(display->childAt(child));
      if (status == nullptr) continue;
      has_status = true;
      ok = ok && status->getLevel() == rviz::StatusProperty::Ok;
      *text << display->getName().toStdString() << " (" << display->getClassId().toStdString()
            << "): " << Word(status->getLevel()) << "\n";
      for (int row = 0; row < status->numChildren(); ++row) {
        const auto* line = dynamic_cast<const rviz::StatusProperty*>(status->childAt(row));
        if (line == nullptr) continue;
        *text << "    " << Word(line->getLevel()) << ": " << line->getName().toStdString() << ": "
              << line->getValue().toString().toStdString() << "\n";
      }
    }
    if (!has_status) {
      *text << display->getName().toStdString() << ": has no status\n";
      ok = false;
    }
  }
  return ok;
}

// Colours in the middle half of a picture.
std::size_t ColoursOf(const QImage& picture) {
  std::set<QRgb> colours;
  for (int y = picture.height() / 4; y < picture.height() * 3 / 4; ++y) {
    for (int x = picture.width() / 4; x < picture.width() * 3 / 4; ++x)
      colours.insert(picture.pixel(x, y));
  }
  return colours.size();
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  ros::init(argc, argv, "rviz_displays", ros::init_options::AnonymousName);
  if (argc != 4) {
    std::cerr << "usage: rviz_displays CONFIG PICTURE SECONDS\n";
    return 2;
  }
  const QString config = QString::fromLocal8Bit(argv[1]), picture = QString::fromLocal8Bit(argv[2]);
  const qint64 patience_ms = 1000 * std::strtoll(argv[3], nullptr, 10);
  ros::NodeHandle node;
  rviz::VisualizationFrame frame;
  frame.setSplashPath("");
  frame.initialize(config);
  frame.show();

  int exit_status = 1, looks = 0;
  QElapsedTimer since;
  since.start();
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    std::ostringstream text;
    // From the screen, for what OpenGL draws is not in the widgets.
    const QImage seen = QApplication::primaryScreen()->grabWindow(frame.winId()).toImage();
    const bool ok =
        AllOk(*frame.getManager()->getRootDisplayGroup(), &text) && ColoursOf(seen) >= kColours;
    looks = ok ? looks + 1 : 0;
    if (looks < kLooks && since.elapsed() < patience_ms) return;
    timer.stop();
    std::cout << text.str() << std::flush;
    std::cout << ColoursOf(seen) << " colours are seen\n";
    const bool saved = seen.save(picture);
    if (!saved) std::cout << "the picture could not be written\n";
    exit_status = ok && saved ? 0 : 1;
    application.quit();
  });
  timer.start(kLook_ms);
  application.exec();
  return exit_status;
}
