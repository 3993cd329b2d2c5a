#include "core/operations/array.h"

#include "core/base/text.h"
#include "core/operations/images.h"

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

constexpr int kMostSections = 500;
constexpr double kMostStep = 2000.0; // mm

void make(OperationContext &context)
{
    std::vector<SectionPointer> sections = context.inputs("sections");
    if (sections.empty())
        return;
    const Vec3 step(context.number("x"), context.number("y"), context.number("z"));
    if (step.isZero(0.0)) {
        context.notice({OperationNotice::Kind::NothingFits});
        return;
    }
    ImageMaker maker(context, std::move(sections));
    for (int i = 1; i < context.count("count"); ++i) {
        std::string mark = " ";
        maker.addCopies(Similarity::moved(i * step), std::to_string(i),
                        mark.append(std::to_string(i + 1)));
    }
}

ParameterSpec stepAlong(const char *key, const char *label, double standard)
{
    return {.key = key,
            .label = label,
            .unit = Unit::Length,
            .standard = standard,
            .least = -kMostStep,
            .most = kMostStep,
            .step = 0.5,
            .sliderLeast = -100.0,
            .sliderMost = 100.0};
}

std::vector<ParameterSpec> parameters()
{
    std::vector<ParameterSpec> all{
        {.key = "count",
         .label = QT_TRANSLATE_NOOP("Operation", "Count"),
         .unit = Unit::Count,
         .standard = 3,
         .least = 2,
         .most = 500,
         .sliderLeast = 2,
         .sliderMost = 20,
         .heading = QT_TRANSLATE_NOOP("Operation", "Line"),
         .tip = QT_TRANSLATE_NOOP("Operation", "Including the sections that are there already")}};
    all.push_back(stepAlong("x", QT_TRANSLATE_NOOP("Operation", "Step X"), 0.0));
    all.push_back(stepAlong("y", QT_TRANSLATE_NOOP("Operation", "Step Y"), 0.0));
    all.push_back(stepAlong("z", QT_TRANSLATE_NOOP("Operation", "Step Z"), 25.0));
    return all;
}

} // namespace

const OperationKind kArray{
    .key = "array",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Array"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Repeats sections along a line through space."),
    //: %1 is the name of a section: "Rib array"
    .calls = [](const Operation &) { return QT_TRANSLATE_NOOP("Operation", "%1 array"); },
    .inputs = {{.role = "sections",
                .label = QT_TRANSLATE_NOOP("Operation", "Sections"),
                .prompt = QT_TRANSLATE_NOOP("Operation", "Click the sections to repeat."),
                .least = 1,
                .most = kMostSections}},
    .parameters = parameters(),
    .make = make};

} // namespace fff
