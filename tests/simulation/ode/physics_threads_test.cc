// What bodies do depends neither on the threads that step them nor on bodies that they do not
// touch.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

constexpr int kBodies = 90;

TestScene Wood() {
  TestScene scene;
  scene.height_m = Hills(1.0, 20.0);
  for (int i = 0; i < 30; ++i) scene.AddTree(-15.0 + 1.1 * i, 5.0 * ((i * 7) % 6) - 13.0, 0.15);
  return scene;
}

// A throng of all kinds, in which everybody runs into somebody.
std::vector<BodyId> Throng(PhysicsWorld* physics) {
  RandomStream random(5, "throng");
  std::vector<BodyId> bodies;
  for (int i = 0; i < kBodies; ++i) {
    const Eigen::Vector3d at(random.Uniform(-11.0, 11.0), random.Uniform(-11.0, 11.0), 1.5);
    const BodySpec specs[] = {Robot(), Walker(60.0, 0.3), Box(8.0, {0.3, 0.2, 0.2}), Robot(),
                              Ball(3.0, 0.2)};
    bodies.push_back(physics->Add(specs[i % 5], at, random.Uniform(-3.0, 3.0)));
  }
  return bodies;
}

void Act(PhysicsWorld* physics, const std::vector<BodyId>& bodies, int step) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double phase = 0.02 * step + static_cast<double>(i);
    if (!physics->SpecOf(bodies[i]).wheels.empty()) {
      DriveAll(physics, bodies[i], 12.0 * std::sin(phase));
    } else if (physics->SpecOf(bodies[i]).upright) {
      physics->SetWalkVelocity(bodies[i], {1.5 * std::cos(phase), 1.5 * std::sin(phase), 0.0});
    }
  }
}

// Lets trees give way to every third blow, and notes the blows.
class Judge : public ContactJudge {
 public:
  bool GivesWay(const Contact& contact) override {
    asked.emplace_back(contact.body, contact.other);
    return asked.size() % 3 == 0;
  }
  std::vector<std::pair<BodyId, std::uint32_t>> asked;
};

std::vector<Eigen::Vector3d> ForcesOf(const PhysicsWorld& physics) {
  std::vector<Eigen::Vector3d> forces;
  for (const Contact& contact : physics.contacts()) forces.push_back(contact.force_n);
  return forces;
}

TEST(PhysicsThreadsTest, EveryNumberOfThreadsGivesTheSame) {
  const auto scene = Wood().Build();
  struct Run {
    std::vector<std::string> digests;
    std::vector<std::vector<Eigen::Vector3d>> forces;
    std::vector<std::pair<BodyId, std::uint32_t>> asked;
  };
  std::vector<Run> runs;
  std::size_t between_bodies = 0;
  for (const int threads : {1, 2, 5}) {
    const auto physics = MakeOdeWorld(scene, threads);
    Judge judge;
    physics->SetJudge(&judge);
    const std::vector<BodyId> bodies = Throng(physics.get());
    Run run;
    for (int step = 0; step < 400; ++step) {
      Act(physics.get(), bodies, step);
      physics->Step(kStep_s, static_cast<std::uint64_t>(step));
      for (const Contact& contact : physics->contacts()) {
        between_bodies += contact.kind == ContactKind::kBody ? 1 : 0;
      }
      if (step % 40 != 39) continue;
      run.digests.push_back(DigestOf(*physics));
      run.forces.push_back(ForcesOf(*physics));
    }
    run.asked = std::move(judge.asked);
    runs.push_back(std::move(run));
  }
  EXPECT_GT(between_bodies, 3000u);
  EXPECT_GT(runs[0].asked.size(), 10u);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].digests, runs[0].digests);
    EXPECT_EQ(runs[i].forces, runs[0].forces);
    EXPECT_EQ(runs[i].asked, runs[0].asked);
  }
}

TEST(PhysicsThreadsTest, ContactsAndQuestionsComeInTheOrderOfTheBodies) {
  const auto scene = Wood().Build();
  const auto physics = MakeOdeWorld(scene, 2);
  // A row of robots runs into a row of trunks; onlookers before them in the list, so that groups
  // hold the robots in another order.
  TestScene trees;
  for (int i = 0; i < 20; ++i) trees.AddTree(3.0, 2.0 * i - 19.0, 0.3);
  const auto row = MakeOdeWorld(trees.Build(), 2);
  Judge judge;
  row->SetJudge(&judge);
  for (int i = 0; i < 55; ++i) row->Add(Ball(3.0, 0.2), {-10.0, 0.7 * i - 19.0, 0.2}, 0.0);
  for (int i = 0; i < 20; ++i) {
    DriveAll(row.get(), row->Add(Robot(), {0.0, 19.0 - 2.0 * i, 0.0}, 0.0), 10.0);
  }
  std::size_t most_in_a_step = 0;
  for (int step = 0; step < 400; ++step) {
    judge.asked.clear();
    row->Step(kStep_s, static_cast<std::uint64_t>(step));
    EXPECT_TRUE(std::is_sorted(judge.asked.begin(), judge.asked.end(),
                               [](const auto& a, const auto& b) { return a.first < b.first; }));
    most_in_a_step = std::max(most_in_a_step, judge.asked.size());
  }
  EXPECT_GE(most_in_a_step, 5u);

  const std::vector<BodyId> bodies = Throng(physics.get());
  for (int step = 0; step < 100; ++step) {
    Act(physics.get(), bodies, step);
    physics->Step(kStep_s, static_cast<std::uint64_t>(step));
    // Those of two bodies, then the others by body.
    BodyId last = 0;
    for (const Contact& contact : physics->contacts()) {
      if (contact.kind == ContactKind::kBody) {
        ASSERT_EQ(last, 0u) << "step " << step;
      } else {
        ASSERT_GE(contact.body, last);
        last = contact.body;
      }
    }
    if (step > 60) {
      ASSERT_GT(last, 0u);
    }
  }
}

TEST_P(PhysicsContract, WhatIsNotTouchedMakesNoDifference) {
  // Three that run into each other, and before, between and behind them in the list others that
  // come and go elsewhere.
  const auto run = [](int others) {
    TestScene scene;
    const auto physics = Make(scene);
    std::vector<BodyId> strangers;
    const auto add_strangers = [&](int count, double x_m) {
      for (int i = 0; i < count; ++i) {
        strangers.push_back(
            physics->Add(Robot(), {x_m + 0.7 * (i % 8), 15.0 - 0.7 * (i / 8), 0.0}, 0.4 * i));
        DriveAll(physics.get(), strangers.back(), 6.0);
      }
    };
    add_strangers(others, -20.0);
    const BodyId one = physics->Add(Robot(), {0.0, 0.0, 0.0}, 0.0);
    add_strangers(others, 0.0);
    const BodyId two = physics->Add(Box(5.0, {0.2, 0.3, 0.25}), {1.5, 0.1, 0.3}, 0.3);
    const BodyId three = physics->Add(Robot(), {3.0, 0.0, 0.0}, M_PI);
    add_strangers(others, 12.0);
    std::vector<Eigen::Vector3d> places;
    for (int step = 0; step < 300; ++step) {
      if (step % 50 == 10 && !strangers.empty()) {
        physics->Remove(strangers.front());
        strangers.erase(strangers.begin());
        add_strangers(1, -10.0 + 0.02 * step);
      }
      const double rate_radps = step < 200 ? 8.0 : -8.0;
      DriveAll(physics.get(), one, rate_radps);
      DriveAll(physics.get(), three, rate_radps);
      physics->Step(kStep_s, static_cast<std::uint64_t>(step));
      for (const BodyId body : {one, two, three}) {
        places.push_back(physics->MotionOf(body).position_m);
        places.push_back(physics->MotionOf(body).angular_velocity_radps);
      }
    }
    return places;
  };
  const auto alone = run(0);
  EXPECT_EQ(run(3), alone);
  EXPECT_EQ(run(24), alone);
}

TEST_P(PhysicsContract, ThoseWhoMetAndPartedGoOnAsInAnyOtherWorld) {
  const TestScene scene = Wood();
  const auto physics = Make(scene);
  std::vector<BodyId> bodies = Throng(physics.get());
  // On springs, on a hinge to the ground, held fast, at rest.
  BodySpec sprung = Robot();
  for (WheelSpec& wheel : sprung.wheels) {
    wheel.spring_npm = 4000.0;
    wheel.damper_nspm = 200.0;
    wheel.travel_m = 0.05;
  }
  for (int i = 0; i < 4; ++i) {
    bodies.push_back(physics->Add(sprung, {-8.0 + 4.0 * i, 5.0, 0.0}, 0.5 * i));
    BodySpec gate = Box(30.0, {0.8, 0.1, 0.5});
    gate.anchor.emplace();
    gate.anchor->kind = i % 2 == 0 ? AnchorKind::kHinge : AnchorKind::kFixed;
    gate.anchor->pivot_m = {-0.8, 0.0, 0.0};
    gate.anchor->low_rad = -1.5;
    gate.anchor->high_rad = 1.5;
    bodies.push_back(physics->Add(gate, {-7.0 + 4.0 * i, -4.0, 0.3}, 0.3 * i));
    bodies.push_back(physics->Add(Box(20.0, {0.3, 0.3, 0.3}), {-6.0 + 4.0 * i, 0.0, 0.4}, 0.0));
  }
  const auto run = [&](PhysicsWorld* world, int from, int to) {
    for (int step = from; step < to; ++step) {
      Act(world, bodies, step);
      world->Step(kStep_s, static_cast<std::uint64_t>(step));
    }
  };
  // As long that whoever parted goes home on the way.
  for (int step = 0; step < 400; step += 40) {
    const auto before = physics->Save();
    const auto other = Make(scene);  // knows nothing of who met whom
    other->Restore(*before);
    run(physics.get(), step, step + 40);
    run(other.get(), step, step + 40);
    ASSERT_EQ(DigestOf(*other), DigestOf(*physics)) << step;
    ASSERT_EQ(ForcesOf(*other), ForcesOf(*physics)) << step;
  }
}

LATTICEWORLD_ON_EVERY_BACK_END(PhysicsContract);

}  // namespace
}  // namespace latticeworld
