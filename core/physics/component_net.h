// A component of a structure as springs.
#pragma once

#include "core/physics/balance.h"
#include "core/physics/contact_search.h"
#include "core/physics/structure.h"

#include <vector>

namespace fff {

/// Which springs stand for what of a component. Its members are numbered as in its list.
struct ComponentNet
{
    SpringNet net;
    std::vector<int> held;     // for each pair of net.holding, from the first on, its foot
    std::vector<int> anchors;  // for each of net.holding after those, the foot it is at
    std::vector<double> grips; // N, of each of component.links; infinite where none is bounded
    std::vector<int> bounded;  // for each of net.pressing after those of the feet, the place in
                               // component.links
};

/// isBounded  links give way at their grip, unless that is beyond all reason; else they hold
ComponentNet componentNet(const Structure &structure, const Component &component,
                          const BodyBalance &body, bool isAxisFree, bool isBounded);

/// Weights, loads, and of bounded links the grip: 6 for each member.
Eigen::VectorXd componentLoad(const Structure &structure, const Component &component,
                              const ComponentNet &net);

} // namespace fff
