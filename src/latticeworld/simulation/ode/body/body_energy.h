#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_BODY_ENERGY_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_BODY_ENERGY_H_

#include "latticeworld/simulation/ode/body/body_control.h"
#include "latticeworld/simulation/ode/body/body_parts.h"
#include "latticeworld/simulation/ode/body/step_start.h"

namespace latticeworld {

// What energy one body has, what a step gave it, and what it may have been given. All but Total()
// is asked after a step was solved and before it is finished.
class BodyEnergy {
 public:
  // They outlive it.
  BodyEnergy(const BodyParts& parts, const BodyControl& control, const StepStart& start)
      : parts_(parts), control_(control), start_(start) {}
  BodyEnergy(const BodyEnergy&) = delete;
  BodyEnergy& operator=(const BodyEnergy&) = delete;

  double Total() const;  // as PhysicsWorld::EnergyOf
  // What the step gave to it beyond the work of gravity and of the forces that were added [J];
  // negative: what it lost to others, to friction and to shocks.
  double Gained(double step_s) const;
  // The most that its motors and springs can have given in a step [J].
  double OfMotors(double step_s) const;
  // The most that pushing it out of what it is in, and walking, can have given in a step [J].
  double OfCorrection() const;
  // Slows all of it down until it has that much less energy of motion, or none.
  void Take(double energy_j);
  // Whether Take was called since this was asked last.
  bool WasTaken();

 private:
  const BodyParts& parts_;
  const BodyControl& control_;
  const StepStart& start_;
  bool taken_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_BODY_ENERGY_H_
