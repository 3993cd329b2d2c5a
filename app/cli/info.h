// What `info` and `parts` say, as JSON (the published keys, in their order) and for people.
#pragma once

#include "core/fabrication/part.h"
#include "core/session/analysis.h"

#include <string>

namespace fff::cli {

struct InfoContext
{
    std::string file;   // as given
    std::string format; // "fff" or "flatfab"
};

/// Lengths mm, angles degrees, masses kg. All texts end with a line end.
std::string infoJson(const Analysis &analysis, const InfoContext &context);
std::string infoText(const Analysis &analysis, const InfoContext &context);

/// Outlines as designed: slits cut, clearance included, kerf not.
std::string partsJson(const std::vector<Part> &parts, const Model &model);
std::string partsText(const std::vector<Part> &parts, const Model &model);

} // namespace fff::cli
