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
        makeStage(kAnalysed, QT_TRANSLATE_NOOP("Stage", "the joints and slits"), {kModel.name},
                  Always, analysed),
        makeStage(kVerdicts, QT_TRANSLATE_NOOP("Stage", "the checks"),
                  {kAnalysed.name, kRules.name}, Always, verdicts),
        makeStage(kPlanned, QT_TRANSLATE_NOOP("Stage", "the order of assembly"),
                  {kAnalysed.name, kRules.name}, WhenSettled, planned),
        makeStage(kFlips, QT_TRANSLATE_NOOP("Stage", "what frees parts that block each other"),
                  {kAnalysed.name, kPlanned.name, kRules.name}, WhenSettled, foundFlips),
        makeStage(kMends, QT_TRANSLATE_NOOP("Stage", "what can be done about problems"),
                  {kAnalysed.name, kVerdicts.name, kPlanned.name, kFlips.name}, WhenSettled, mends),
    };
    return all;
}

} // namespace fff
