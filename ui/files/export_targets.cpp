#include "ui/files/export_targets.h"

#include "ui/settings/settings.h"

namespace fff::ui {

namespace {

const QString kTargetsKey = QStringLiteral("export/targets");
constexpr qsizetype kTargetFields = 3; // model, path, kind: newest first

} // namespace

std::optional<ExportTarget> rememberedTarget(const QString &model)
{
    const QStringList kept = settings().memory(kTargetsKey).toStringList();
    for (qsizetype i = 0; !model.isEmpty() && i + kTargetFields <= kept.size(); i += kTargetFields)
        if (kept[i] == model)
            return ExportTarget{kept[i + 1], kept[i + 2]};
    return std::nullopt;
}

void rememberTarget(const QString &model, const ExportTarget &target)
{
    if (model.isEmpty())
        return;
    const QStringList kept = settings().memory(kTargetsKey).toStringList();
    QStringList next{model, target.path, target.kind};
    for (qsizetype i = 0; i + kTargetFields <= kept.size(); i += kTargetFields)
        if (kept[i] != model && next.size() < kTargetFields * kMostTargets)
            next += kept.mid(i, kTargetFields);
    settings().setMemory(kTargetsKey, next);
}

} // namespace fff::ui
