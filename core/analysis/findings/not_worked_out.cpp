#include "core/analysis/findings/not_worked_out.h"

#include "core/analysis/stage.h"

namespace fff {

namespace {

Message failureSentence(const Finding &finding, const Model &)
{
    const StageFailure &failure = *finding.details<StageFailure>();
    if (failure.why.code == ErrorCode::Cancelled)
        //: %1 is what would have been found out: "the order of assembly"
        return {FFF_TEXT("Stage", "Stopped: %1. It is worked out again when the model changes."),
                {failure.title}};
    //: %1 is what would have been found out: "the order of assembly", %2 a sentence
    return {FFF_TEXT("Stage", "Could not be worked out: %1. Reason: %2."),
            {failure.title, failure.why}};
}

constexpr Text kTryText = FFF_TEXT("Checks", "Try again");
constexpr Text kReportText = FFF_TEXT("Checks", "Show the copy for a report");

} // namespace

const ActionKind kTryAgain{plainWords<kTryText>};
const ActionKind kShowReport{plainWords<kReportText>};

const FindingKind kNotWorkedOut{"notWorkedOut", Subject::Joints,
                                FFF_TEXT("Checks", "Not worked out"), failureSentence};
const FindingKind kOrderNotWorkedOut{"notWorkedOut", Subject::Assembly,
                                     FFF_TEXT("Checks", "Not worked out"), failureSentence};
const FindingKind kStrengthNotWorkedOut{"notWorkedOut", Subject::Strength,
                                        FFF_TEXT("Checks", "Not worked out"), failureSentence};

Finding notWorkedOut(const Stage &stage, Error why)
{
    return makeFinding(*stage.failing, Severity::Unknown,
                       StageFailure{stage.name, stage.title, std::move(why)});
}

} // namespace fff
