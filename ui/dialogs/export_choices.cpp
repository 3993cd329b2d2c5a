#include "ui/dialogs/export_choices.h"

#include "core/io/machine_library.h"
#include "ui/settings/settings.h"

#include <algorithm>
#include <iterator>

namespace fff::ui {

namespace {

const QString kSpacingKey = QStringLiteral("export/spacing"),
              kMarginKey = QStringLiteral("export/margin"),
              kTurnsKey = QStringLiteral("export/turnsFreely"), // of versions before:
    kTurningKey = QStringLiteral("export/turning"), kHolesKey = QStringLiteral("export/fillsHoles"),
              kReferenceKey = QStringLiteral("export/reference"),
              kJointColoursKey = QStringLiteral("export/jointColours"),
              kMachineKey = QStringLiteral("export/machine"),
              kTabsKey = QStringLiteral("export/bridges"),
              kTabWidthKey = QStringLiteral("export/bridgeWidth"),
              kLeadKey = QStringLiteral("export/lead"),
              kOwnCutsKey = QStringLiteral("export/ownCuts"),
              kSharesKey = QStringLiteral("export/sharesCuts"),
              kFolderKey = QStringLiteral("export/opensFolder"),
              kFileKey = QStringLiteral("export/file"), kFilesKey = QStringLiteral("export/files");

/// What cannot be made sense of is what is usual.
double lengthKept(const QString &key, double usual, double most)
{
    bool isNumber = false;
    const double kept = settings().memory(key).toDouble(&isNumber);
    return isNumber && kept >= 0.0 && kept <= most ? kept : usual;
}

bool switchKept(const QString &key, bool usual)
{
    const QVariant kept = settings().memory(key);
    return kept.isValid() ? kept.toBool() : usual;
}

/// In the order of nest::Turning.
const char *const kTurnings[] = {"none", "half", "quarter", "free"};

nest::Turning turningKept()
{
    const QString kept = settings().memory(kTurningKey).toString();
    const auto found = std::find_if(std::begin(kTurnings), std::end(kTurnings),
                                    [&](const char *name) { return kept == QLatin1String(name); });
    if (found != std::end(kTurnings))
        return static_cast<nest::Turning>(found - std::begin(kTurnings));
    return switchKept(kTurnsKey, true) ? nest::Turning::Free : nest::Turning::Quarter;
}

/// Of versions before, which kept no word of it, what is not plain was chosen.
std::optional<CutFinish> finishKept()
{
    const CutFinish usual;
    CutFinish finish;
    finish.tabs = static_cast<int>(lengthKept(kTabsKey, usual.tabs, kMostTabs));
    finish.tabWidth =
        std::max(kLeastTabWidth, lengthKept(kTabWidthKey, usual.tabWidth, kMostTabWidth));
    finish.lead = lengthKept(kLeadKey, usual.lead, kMostLead);
    finish.sharesCuts = switchKept(kSharesKey, usual.sharesCuts);
    return switchKept(kOwnCutsKey, !finish.isPlain()) ? std::optional(finish) : std::nullopt;
}

} // namespace

NestOptions ExportChoices::nesting() const
{
    NestOptions options;
    options.layout = layout;
    options.turning = turning;
    options.fillsHoles = fillsHoles;
    return options;
}

CuttingOptions ExportChoices::cutting() const
{
    CuttingOptions options;
    options.layout = layout;
    options.nesting = nesting();
    options.hasReference = hasReference;
    options.hasJointColours = hasJointColours;
    options.finish = finish;
    options.machine = chosenMachine();
    return options;
}

std::shared_ptr<const Machine> ExportChoices::chosenMachine() const
{
    const auto library = io::machineLibrary();
    const auto found = std::find_if(library.begin(), library.end(), [this](const auto &one) {
        return QString::fromStdString(one->key) == machine;
    });
    return found == library.end() ? nullptr : *found;
}

CutFinish ExportChoices::cuts() const
{
    const std::shared_ptr<const Machine> chosen = chosenMachine();
    return finish.value_or((chosen ? *chosen : usualMachine()).finish);
}

ExportChoices rememberedChoices()
{
    ExportChoices choices;
    choices.layout.spacing = lengthKept(kSpacingKey, choices.layout.spacing, kMostSpacing);
    choices.layout.margin = lengthKept(kMarginKey, choices.layout.margin, kMostMargin);
    choices.turning = turningKept();
    choices.fillsHoles = switchKept(kHolesKey, choices.fillsHoles);
    choices.hasReference = switchKept(kReferenceKey, choices.hasReference);
    choices.hasJointColours = switchKept(kJointColoursKey, choices.hasJointColours);
    choices.finish = finishKept();
    choices.machine = settings().memory(kMachineKey).toString();
    choices.opensFolder = switchKept(kFolderKey, choices.opensFolder);
    choices.file = settings().memory(kFileKey).toString();
    choices.files = settings().memory(kFilesKey).toStringList();
    return choices;
}

void rememberChoices(const ExportChoices &choices)
{
    settings().setMemory(kSpacingKey, choices.layout.spacing);
    settings().setMemory(kMarginKey, choices.layout.margin);
    settings().setMemory(kTurningKey,
                         QLatin1String(kTurnings[static_cast<std::size_t>(choices.turning)]));
    settings().setMemory(kHolesKey, choices.fillsHoles);
    settings().setMemory(kReferenceKey, choices.hasReference);
    settings().setMemory(kJointColoursKey, choices.hasJointColours);
    const CutFinish finish = choices.finish.value_or(CutFinish());
    settings().setMemory(kOwnCutsKey, choices.finish.has_value());
    settings().setMemory(kTabsKey, finish.tabs);
    settings().setMemory(kTabWidthKey, finish.tabWidth);
    settings().setMemory(kLeadKey, finish.lead);
    settings().setMemory(kSharesKey, finish.sharesCuts);
    settings().setMemory(kMachineKey, choices.machine);
    settings().setMemory(kFolderKey, choices.opensFolder);
    settings().setMemory(kFileKey, choices.file);
    settings().setMemory(kFilesKey, choices.files);
    Q_EMIT settings().exportChanged();
}

} // namespace fff::ui
