// What it costs to say whether a model holds.
#pragma once

#include "tests/bench/peer.h"

#include <optional>
#include <string>
#include <vector>

namespace fff::bench {

/// CPU time of one thread in milliseconds; of several runs the shortest. Joints, slits, cut
/// sections and bodies are there.
struct StrengthCost
{
    std::string name;
    int sections = 0, joints = 0;
    int neighbours = 0;     // of the section that is edited
    double structure = 0.0; // bodies to what mechanics sees of them
    double forces = 0.0;    // that to one equilibrium of rigid bodies
    double cuts = 0.0;      // bodies to where they are cut
    double rigid = 0.0;     // all of these and the stresses: nothing known from before
    double envelope = 0.0;  // the same with all the equilibria that count, as the window has it
    double edited = 0.0;    // `rigid` after one section was moved, with what is known from before
    double envelopeEdited = 0.0; // `envelope`, too
    std::optional<double> bent;  // forces alone of bodies that bend, whose flexibilities are known;
                                 // none where that is not asked, or there are too many joints
    double kernel = 0.0;         // ms, as in Measurement
};

/// edited   index of the section that is moved; −1: one in the middle by its number of joints
Result<StrengthCost> strengthCost(const std::string &name, const QString &path, int runs,
                                  int edited = -1);

/// In kernels where they were run, beside the old program's, and growth of models that differ in
/// size alone.
std::string strengthTables(const std::vector<StrengthCost> &rows, const std::optional<Peer> &peer);

} // namespace fff::bench
