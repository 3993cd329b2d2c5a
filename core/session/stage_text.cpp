#include "core/session/stage_text.h"

#include "core/analysis/stages.h"
#include "core/io/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(Stage)
};

} // namespace

QString stageTitle(std::string_view stage)
{
    const auto known = std::find_if(stages().begin(), stages().end(),
                                    [&](const Stage &one) { return stage == one.name; });
    return known == stages().end() ? QString::fromUtf8(stage.data(), static_cast<int>(stage.size()))
                                   : QCoreApplication::translate("Stage", known->title);
}

QString stageWork(std::string_view stage, double share)
{
    if (share < 0.0)
        //: %1 is what is found out: "the order of assembly"
        return Words::tr("Working out %1…").arg(stageTitle(stage));
    //: %1 is what is found out: "the order of assembly", %2 a number
    return Words::tr("Working out %1… %2\u202f%")
        .arg(stageTitle(stage))
        .arg(std::floor(100.0 * share));
}

QString stageFailure(std::string_view stage, const Error &why)
{
    if (why.code == ErrorCode::Cancelled)
        //: %1 is what would have been found out: "the order of assembly"
        return Words::tr("Stopped: %1. It is worked out again when the model changes.")
            .arg(stageTitle(stage));
    //: %1 is what would have been found out: "the order of assembly", %2 a sentence
    return Words::tr("Could not be worked out: %1. The reason: %2.")
        .arg(stageTitle(stage), io::errorSentence(why));
}

} // namespace fff
