#include "core/analysis/stages.h"

#include "core/analysis/analysed.h"
#include "core/analysis/mends.h"
#include "core/analysis/planned.h"
#include "core/analysis/verdicts.h"
#include "core/base/text.h"

namespace fff {

const std::vector<Stage> &stages()
{
    using enum Stage::Runs;
    static const std::vector<Stage> all = {
        makeStage(kAnalysed, QT_TRANSLATE_NOOP("Stage", "Joints and slits"), {kModel.name}, Always,
                  analysed),
        makeStage(kVerdicts, QT_TRANSLATE_NOOP("Stage", "Checks"), {kAnalysed.name, kRules.name},
                  Always, verdicts),
        makeStage(kPlanned, QT_TRANSLATE_NOOP("Stage", "Order of assembly"),
                  {kAnalysed.name, kRules.name}, WhenSettled, planned),
        makeStage(kFlips, QT_TRANSLATE_NOOP("Stage", "What frees parts that block each other"),
                  {kAnalysed.name, kPlanned.name, kRules.name}, WhenSettled, foundFlips),
        makeStage(kMends, QT_TRANSLATE_NOOP("Stage", "What can be done about problems"),
                  {kAnalysed.name, kVerdicts.name, kPlanned.name, kFlips.name}, WhenSettled, mends),
    };
    return all;
}

} // namespace fff
