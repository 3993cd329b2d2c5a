// Where models were exported to last, so that the same can be had again without a question.
#pragma once

#include <QString>

#include <optional>

namespace fff::ui {

struct ExportTarget
{
    QString path;
    QString kind; // key of an ExportKind
    bool operator==(const ExportTarget &) const = default;
};

/// Of a model's file, by its path; nothing for one that was never exported, and for an empty path.
std::optional<ExportTarget> rememberedTarget(const QString &model);
/// The last kMostTargets models' are kept.
void rememberTarget(const QString &model, const ExportTarget &target);
inline constexpr int kMostTargets = 24;

} // namespace fff::ui
