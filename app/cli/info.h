// What `info` and `parts` say, as JSON (the published keys, in their order) and for people.
#pragma once

#include "core/analysis/assembly_plan.h"
#include "core/analysis/finding.h"
#include "core/fabrication/part.h"

#include <QStringList>

#include <chrono>
#include <string>

namespace fff::cli {

struct InfoContext
{
    std::string file;   // as given
    std::string format; // "fff" or "flatfab"
};

/// Lengths mm, angles degrees, masses kg. JSON ends with a line end; texts are lines.
/// found  all that is, of them (all_found.h)
std::string infoJson(const Analysis &analysis, const ModelPlan &plan,
                     const std::vector<Finding> &found, const InfoContext &context);
QStringList infoText(const Analysis &analysis, const std::vector<Finding> &found,
                     const InfoContext &context);

/// Outlines as designed: slits cut, clearance included, kerf not; and the order of assembly.
std::string partsJson(const std::vector<Part> &parts, const Model &model, const AssemblyPlan &plan);
QStringList partsText(const std::vector<Part> &parts, const Model &model, const AssemblyPlan &plan);

/// So long an order of assembly is looked for; nobody waits for a frame here.
inline constexpr std::chrono::seconds kPlanningTime(10);

} // namespace fff::cli
