#include "core/analysis/stages.h"

#include "core/analysis/accurate.h"
#include "core/analysis/analysed.h"
#include "core/analysis/asked_bearing.h"
#include "core/analysis/asked_skin.h"
#include "core/analysis/holding.h"
#include "core/analysis/mends.h"
#include "core/analysis/nested.h"
#include "core/analysis/planned.h"
#include "core/analysis/pulling.h"
#include "core/analysis/verdicts.h"

namespace fff {

namespace {

std::vector<Stage> allStages()
{
    using enum Stage::Runs;
    std::vector<Stage> all = {
        makeStage(kAnalysed, FFF_TEXT("Stage", "the joints and slits"), {kModel.name}, Always,
                  analysed),
        makeStage(kVerdicts, FFF_TEXT("Stage", "the checks"), {kAnalysed.name, kRules.name}, Always,
                  verdicts),
        makeStage(kPlanned, FFF_TEXT("Stage", "the order of assembly"),
                  {kAnalysed.name, kRules.name}, Always, planned)
            .failingAs(kOrderNotWorkedOut),
        makeStage(kHolding, FFF_TEXT("Stage", "whether it holds"), {kAnalysed.name, kRules.name},
                  Always, holding)
            .failingAs(kStrengthNotWorkedOut),
        makeStage(kAccurate, FFF_TEXT("Stage", "how much it holds when sections bend"),
                  {kAnalysed.name, kRules.name}, WhenSettled, accurate)
            .refining(kHolding.name),
        makeStage(kBearing, FFF_TEXT("Stage", "how much each place of a section holds"),
                  {kAnalysed.name, kRules.name, kQuestions.name}, WhenSettled, askedBearing),
        makeStage(kSkin, FFF_TEXT("Stage", "the skin"), {kModel.name, kQuestions.name}, WhenSettled,
                  askedSkin),
        makeStage(kNested, FFF_TEXT("Stage", "how parts lie on the sheets"),
                  {kAnalysed.name, kSheetsAsked.name}, WhenSettled, nested),
        makeStage(kPulled, FFF_TEXT("Stage", "what magnets make of templates"), {kModel.name},
                  Always, pulled),
        makeStage(kFlips, FFF_TEXT("Stage", "what frees parts that block each other"),
                  {kAnalysed.name, kPlanned.name, kRules.name}, WhenSettled, foundFlips),
    };
    all.push_back(mendsOf(all));
    return all;
}

} // namespace

const std::vector<Stage> &stages()
{
    static const std::vector<Stage> all = allStages();
    return all;
}

} // namespace fff
