// Samples with values: whoever moves a slider of one gets a model that can be cut, at any place.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/value_trials.h"
#include "core/io/document_file.h"
#include "core/model/bindings.h"
#include "core/operations/baking.h"
#include "core/operations/evaluate.h"
#include "core/session/message_text.h"
#include "core/values/presets.h"
#include "tests/test_program.h"

#include <QDir>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace fff;

namespace {

/// Of what is drawn, after a slider went elsewhere and back, mm.
constexpr double kSameDrawing = 1e-6;

struct AdjustableSample
{
    std::string name;
    Model model;
    std::vector<RangedValue> values;
};

std::vector<AdjustableSample> readSamples()
{
    std::vector<AdjustableSample> all;
    const QDir folder(QStringLiteral(FFF_SAMPLES), QStringLiteral("*.fff"));
    for (const QFileInfo &file : folder.entryInfoList()) {
        const auto read = io::readDocument(file.filePath());
        if (!read)
            continue; // tst_samples tells
        AdjustableSample sample{
            file.completeBaseName().toStdString(), evaluate(read->document), {}};
        sample.values = rangedValues(sample.model);
        if (!sample.values.empty())
            all.push_back(std::move(sample));
    }
    return all;
}

const std::vector<AdjustableSample> &adjustableSamples()
{
    static const std::vector<AdjustableSample> kSamples = readSamples();
    return kSamples;
}

TrialPlace placeNow(const AdjustableSample &sample)
{
    TrialPlace place;
    for (const RangedValue &value : sample.values)
        place.push_back(value.now(sample.model));
    return place;
}

double farthest(const Contour &a, const Contour &b)
{
    if (a.points().size() != b.points().size())
        return std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (std::size_t i = 0; i < a.points().size(); ++i)
        most = std::max(most, (a.points()[i] - b.points()[i]).norm());
    return most;
}

/// By how much at most what one has is elsewhere in the other, mm; infinite where one has more.
double farthest(const Model &a, const Model &b)
{
    const std::vector<SectionPointer> first = a.sections(), second = b.sections();
    double most = first.size() == second.size() ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        const Section &one = *first[i], &other = *second[i];
        most = std::max({most, farthest(one.shape->contour(), other.shape->contour()),
                         (one.frame.origin - other.frame.origin).norm(),
                         100.0 * (one.frame.x - other.frame.x).norm(),
                         100.0 * (one.frame.y - other.frame.y).norm()});
        if (one.shape->holes().size() != other.shape->holes().size())
            return std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < one.shape->holes().size(); ++k)
            most = std::max(most, farthest(one.shape->holes()[k], other.shape->holes()[k]));
    }
    return most;
}

QByteArray toldOf(const AdjustableSample &sample, double apart)
{
    return QByteArray::fromStdString(sample.name) + ": " + QByteArray::number(apart) + " mm";
}

QByteArray saidOf(const AdjustableSample &sample, const TriedPlace &place)
{
    QString text = QString::fromStdString(sample.name);
    for (const auto &[name, worth] : worthsAt(sample.values, place.at))
        text += QStringLiteral(" %1=%2").arg(QString::fromStdString(name)).arg(worth.number);
    for (const Message &fault : place.faults)
        text += QStringLiteral(": ") + messageText(fault);
    return text.toUtf8();
}

} // namespace

class TestAdjustableSamples : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thereAreSix();
    void eachValueCanBeSetToWhatItIs();
    void allPlacesOfTheRangesAreGood();
    void presetsAreInTheRanges();
    void bakedItStillFollows();
    void ofSeveralThatChangeOneEachIsBaked();
    void aSliderLeavesNoTrace();
    void allWaysLeadToTheSamePlace();
    void anyNameFitsItsPlate();
};

// Wrong: what the help and the start page promise is not there.
void TestAdjustableSamples::thereAreSix()
{
    const std::vector<AdjustableSample> &all = adjustableSamples();
    for (const char *name :
         {"drawer_organiser", "gears", "glass_four_legs", "lamp", "name_plate", "shelf"})
        QVERIFY2(std::any_of(all.begin(), all.end(),
                             [name](const AdjustableSample &one) { return one.name == name; }),
                 name);
}

// Wrong: a slider that jumps as it is touched, or one that moves nothing.
void TestAdjustableSamples::eachValueCanBeSetToWhatItIs()
{
    for (const AdjustableSample &sample : adjustableSamples()) {
        std::size_t numbers = 0;
        for (const ValuePointer &known : sample.model.document.values.list)
            numbers += known->value.isShown && known->value.kind != ValueKind::Text ? 1 : 0;
        QCOMPARE(sample.values.size(), numbers);
        for (const RangedValue &value : sample.values) {
            const double now = value.now(sample.model);
            QVERIFY2(std::abs(value.settable(now) - now) < 1e-9, value.name.c_str());
            QVERIFY2(value.least < value.most, value.name.c_str());
        }
    }
}

void TestAdjustableSamples::allPlacesOfTheRangesAreGood()
{
    for (const AdjustableSample &sample : adjustableSamples()) {
        Progress progress;
        const TrialExtent extent{.seed = 29, .mostCorners = 32, .random = 12};
        const auto trials = tryValues(sample.model, {}, extent, progress, {});
        QVERIFY(trials);
        for (const TriedPlace &place : trials->places) {
            QVERIFY2(place.holds(), saidOf(sample, place));
            for (const Severity worst : place.worst)
                QVERIFY2(worst < Severity::Warning, saidOf(sample, place));
        }
    }
}

// So they are good, too.
void TestAdjustableSamples::presetsAreInTheRanges()
{
    int count = 0;
    for (const AdjustableSample &sample : adjustableSamples())
        for (const PresetPointer &preset : sample.model.document.values.presets) {
            Document document = sample.model.document;
            document.values = setByPreset(document.values, *preset);
            const Model set = evaluate(document, sample.model);
            QVERIFY2(set.evaluation.drivingErrors.empty(), preset->name.c_str());
            QCOMPARE(presetInUse(set.document.values)->name, preset->name);
            for (const RangedValue &value : sample.values) {
                const double now = value.now(set);
                QVERIFY2(value.least <= now && now <= value.most &&
                             std::abs(value.settable(now) - now) < 1e-9,
                         (preset->name + ": " + value.name).c_str());
            }
            ++count;
        }
    QVERIFY(count > 6);
}

// Wrong: legs are baked, and the ring that they stand around is cut in another size than the slider
// says.
void TestAdjustableSamples::bakedItStillFollows()
{
    const auto &samples = adjustableSamples();
    const auto glass =
        std::find_if(samples.begin(), samples.end(),
                     [](const AdjustableSample &one) { return one.name == "glass_four_legs"; });
    const Document &before = glass->model.document;
    const Document after = evaluate(*baked(glass->model, before.operations[0]->id)).document;
    QCOMPARE(after.bindings.size(), before.bindings.size() - 1); // the number of legs
    const auto widths = [](Document document) {
        const ValueId id = document.values.find(std::string_view("diameter"))->id;
        document = typeValue(std::move(document), id, "92 mm", {}).value();
        std::vector<double> all;
        for (const SectionPointer &section : evaluate(document).document.sections)
            if (section->name == "Ring" || section->name == "Shelf")
                all.push_back(section->shape->bounds().size().x());
        return all;
    };
    const std::vector<double> wide = widths(before), bakedWide = widths(after);
    QCOMPARE(bakedWide.size(), std::size_t(2));
    for (std::size_t i = 0; i < wide.size(); ++i)
        QVERIFY(std::abs(wide[i] - bakedWide[i]) < 1e-9);
}

// Wrong: teeth were drawn along with the ring of holes that was baked, and what drives the wheel's
// numbers was lost.
void TestAdjustableSamples::ofSeveralThatChangeOneEachIsBaked()
{
    const auto &samples = adjustableSamples();
    const auto gears = std::find_if(samples.begin(), samples.end(),
                                    [](const auto &one) { return one.name == "gears"; });
    const Document &before = gears->model.document;
    for (const OperationPointer &operation : before.operations) {
        if (operation->kind != "radial")
            continue;
        const auto ofIt = std::count_if(
            before.bindings.begin(), before.bindings.end(), [&](const BindingPointer &pointer) {
                const DrivenPlace &place = pointer->binding.place;
                return place.of == DrivenPlace::Of::Operation && place.id == operation->id.value;
            });
        const Model after = evaluate(*baked(gears->model, operation->id));
        // The disc under its teeth is drawn with them, and has no diameter any more.
        const bool takesDisc =
            operation->parameters.at("kind") == ParameterValue(std::string("gear"));
        QVERIFY(after.evaluation.drivingErrors.empty());
        QCOMPARE(after.document.bindings.size() + static_cast<std::size_t>(ofIt) +
                     (takesDisc ? 1 : 0),
                 before.bindings.size());
        QCOMPARE(after.sectionCount(), gears->model.sectionCount());
        for (std::size_t i = 0; i < after.sectionCount(); ++i)
            QVERIFY2(std::abs(after.section(i)->shape->area() -
                              gears->model.section(i)->shape->area()) < 1e-3,
                     operation->name.c_str());
    }
}

// Wrong: a model that is another one after a slider went to both ends and back.
void TestAdjustableSamples::aSliderLeavesNoTrace()
{
    for (const AdjustableSample &sample : adjustableSamples()) {
        const TrialPlace now = placeNow(sample);
        Document document = sample.model.document;
        for (std::size_t i = 0; i < now.size(); ++i) {
            for (const double at : {sample.values[i].least, sample.values[i].most, now[i]}) {
                TrialPlace place = now;
                place[i] = at;
                document = placed(document, sample.values, place).value();
            }
        }
        QCOMPARE(document.bindings.size(), sample.model.document.bindings.size());
        const double moved = farthest(evaluate(document), sample.model);
        QVERIFY2(moved < kSameDrawing, toldOf(sample, moved));
    }
}

// Wrong: sizes that depend on which slider was moved first.
void TestAdjustableSamples::allWaysLeadToTheSamePlace()
{
    for (const AdjustableSample &sample : adjustableSamples()) {
        const TrialPlaces places = trialPlaces(sample.values, {.seed = 5, .random = 6});
        Document document = sample.model.document;
        for (const TrialPlace &place : places.all) {
            document = placed(document, sample.values, place).value();
            const Document direct = placed(sample.model.document, sample.values, place).value();
            const double apart = farthest(evaluate(document), evaluate(direct));
            QVERIFY2(apart < kSameDrawing, toldOf(sample, apart));
        }
    }
}

// Wrong: a name that runs over the edge, or a plate that no sheet has room for.
void TestAdjustableSamples::anyNameFitsItsPlate()
{
    const std::vector<AdjustableSample> &all = adjustableSamples();
    const auto plate = std::find_if(all.begin(), all.end(), [](const AdjustableSample &one) {
        return one.name == "name_plate";
    });
    QVERIFY(plate != all.end());
    const Document &document = plate->model.document;
    for (const char *letters : {"12 mm", "30 mm"})
        for (const std::string &name :
             {std::string("I"), std::string("Bo"), std::string("Œuvre & Größe"),
              std::string("Grace Murray Hopper"), std::string(80, 'n')}) {
            const Document sized =
                typeValue(document, document.values.find("letters")->id, letters, {}).value();
            const Model model =
                evaluate(typeValue(sized, document.values.find("name")->id, name, {}).value());
            const Section &shield = *model.section(0);
            QCOMPARE(shield.marks.size(), std::size_t(1));
            QVERIFY(shield.marks[0]->lettering);
            QCOMPARE(shield.marks[0]->lettering->text, name);
            const Box2 &room = shield.shape->bounds();
            QVERIFY2(room.size().x() < 588.0, name.c_str());
            for (const CurvePath &path : shield.marks[0]->paths)
                for (const Vec2 &p : path.points())
                    QVERIFY2((p - room.min).minCoeff() > 3.0 && (room.max - p).minCoeff() > 3.0,
                             name.c_str());
        }
}

FFF_TEST(TestAdjustableSamples)
#include "tst_adjustable_samples.moc"
