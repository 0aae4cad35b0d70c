#!/usr/bin/env bash
# ODE's contact with a height field is too shallow by a body's whole height once the body lies wholly below.
#
# Versions: libode-dev 2:0.16.2-1 and g++ of Debian 12.
# Expected: The depth of a contact is how far the body has to be moved along the normal until it no longer penetrates. It
# grows by a centimetre for each centimetre that a ball sinks into level ground.
# Observed: It does so until the top of the ball is as low as the lowest height under it. Then it falls to zero and grows
# again from there: it is the distance of the ball's top from the ground, not of its bottom. A ball of 0.6 m that was
# carried 1 cm below in one step is 1 cm deep instead of 61 cm. A solver that moves it by the depth leaves it in the
# ground, and a program that ranks or filters contacts by depth takes the worst one for the slightest.
# Since: 0.16.2 is the only version that was tried.
set -euo pipefail
export PATH=/usr/bin:/bin:$PATH

have=$(dpkg-query -W -f '${Version}' libode-dev)
[ "$have" = 2:0.16.2-1 ] || { echo "libode-dev is $have, not 2:0.16.2-1."; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat > below.cc <<'CC'
#include <ode/ode.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  dInitODE();
  // 9 x 9 samples, a metre apart, all of height 1. ODE's height fields have y up.
  const std::vector<float> heights(81, 1.0f);
  dHeightfieldDataID data = dGeomHeightfieldDataCreate();
  dGeomHeightfieldDataBuildSingle(data, heights.data(), 0, 8, 8, 9, 9, 1, 0, 1, 0);
  dGeomID ground = dCreateHeightfield(nullptr, data, 1);
  dGeomID ball = dCreateSphere(nullptr, 0.3);
  for (const double middle : {1.25, 1.0, 0.75, 0.71, 0.69, 0.5}) {
    dGeomSetPosition(ball, 0.5, middle, 0.2);
    dContactGeom contact;
    const int count = dCollide(ball, ground, 1, &contact, sizeof contact);
    std::printf("bottom %.2f below the ground: %d contact, normal up %.2f, depth %.2f\n", 1.3 - middle, count,
                contact.normal[1], contact.depth);
  }
  dCloseODE();
}
CC
g++ -std=c++17 below.cc -o below -lode
./below | tee seen.txt

grep -q '^bottom 0.05 below the ground: 1 contact, normal up 1.00, depth 0.05$' seen.txt
grep -q '^bottom 0.55 below the ground: 1 contact, normal up 1.00, depth 0.55$' seen.txt
grep -q '^bottom 0.59 below the ground: 1 contact, normal up 1.00, depth 0.59$' seen.txt
grep -q '^bottom 0.61 below the ground: 1 contact, normal up 1.00, depth 0.01$' seen.txt
grep -q '^bottom 0.80 below the ground: 1 contact, normal up 1.00, depth 0.20$' seen.txt
echo "The behaviour is as described."
