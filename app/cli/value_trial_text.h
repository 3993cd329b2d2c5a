// `values --try`: what becomes of a model over the ranges of its shown values.
#pragma once

#include "core/analysis/value_trials.h"

#include <QStringList>

namespace fff::io {
class JsonWriter;
}

namespace fff::cli {

/// Columns of verdicts, published: of `variants`, and of what is tried.
struct VerdictColumn
{
    const char *name;
    Subject subject;
};
inline constexpr VerdictColumn kVerdictColumns[] = {{"connection", Subject::Connection},
                                                    {"stability", Subject::Stability},
                                                    {"assembly", Subject::Assembly},
                                                    {"strength", Subject::Strength},
                                                    {"size", Subject::Size},
                                                    {"joints", Subject::Joints}};

ValueTrials triedValues(const Document &document, std::uint64_t seed);
QStringList trialsText(const ValueTrials &trials);
/// As the member "tried" of what is open.
void writeTrials(io::JsonWriter &json, const ValueTrials &trials);

} // namespace fff::cli
