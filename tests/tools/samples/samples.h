// The samples that are built from numbers. Each writes FOLDER/NAME.fff; NAME is that of
// ui/start/samples.cpp.
#pragma once

#include <string>

namespace fff::samples {

void fish(const std::string &folder);
void tree(const std::string &folder);
void chair(const std::string &folder);
void glassHolder(const std::string &folder);
void organiser(const std::string &folder);
void lamp(const std::string &folder);

// With values that whoever opens them adjusts (tests/core/session/tst_adjustable_samples).
void shelf(const std::string &folder);
void drawerOrganiser(const std::string &folder);
void namePlate(const std::string &folder);

// After figures of J. McCrae et al. 2014, FlatFitFab: each shows an operation at work.
void bonyFish(const std::string &folder);
void bridge(const std::string &folder);
void beetle(const std::string &folder);
void twoPoses(const std::string &folder);
void dinosaur(const std::string &folder);
void growingTree(const std::string &folder);
void whale(const std::string &folder);
void gears(const std::string &folder);
void cutleryMan(const std::string &folder);
void glassOnThreeLegs(const std::string &folder);
void glassOnFourLegs(const std::string &folder);
void acrylicThinThree(const std::string &folder);
void acrylicThinFour(const std::string &folder);
void acrylicThickThree(const std::string &folder);
void acrylicThickFour(const std::string &folder);

} // namespace fff::samples
