// What kinds of joints are called in files, commands and on the command line.
#pragma once

#include "core/model/joint_override.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fff {

inline constexpr std::array<std::pair<std::string_view, JointKind>, 5> kJointKindNames{
    {{"crossLap", JointKind::CrossLap},
     {"extendedCrossLap", JointKind::ExtendedCrossLap},
     {"mortise", JointKind::Mortise},
     {"tabs", JointKind::Tabs},
     {"none", JointKind::None}}};

constexpr std::string_view nameOf(JointKind kind)
{
    for (const auto &[name, named] : kJointKindNames)
        if (named == kind)
            return name;
    return {}; // not reached: every kind is above
}

constexpr std::optional<JointKind> jointKindNamed(std::string_view name)
{
    for (const auto &[known, kind] : kJointKindNames)
        if (known == name)
            return kind;
    return {};
}

} // namespace fff
