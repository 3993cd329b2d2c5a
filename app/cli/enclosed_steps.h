// How a model goes together, among what a workshop gets.
#pragma once

#include "core/analysis/analysis.h"
#include "core/fabrication/layout.h"
#include "core/io/file_set.h"

#include <QString>

#include <memory>
#include <vector>

namespace fff::cli {

/// "steps.pdf"; none, and why, where there are no steps, or no display to draw them on.
/// title  on its pages; layout  of what is cut
std::vector<io::NamedBytes> enclosedSteps(const Analysis &analysis, const QString &title,
                                          std::shared_ptr<const Layout> layout, QString &why);

} // namespace fff::cli
