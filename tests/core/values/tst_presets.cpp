// Presets: what is kept, what it sets, and that every edit of values leaves them whole.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/values/presets.h"
#include "core/values/value_edits.h"
#include "tests/rounds.h"
#include "tests/test_program.h"

#include <algorithm>
#include <random>
#include <set>

using namespace fff;

namespace {

Value shown(std::int64_t id, std::string name, std::string typed,
            ValueKind kind = ValueKind::Length)
{
    Value value;
    value.id = ValueId{id};
    value.name = std::move(name);
    value.kind = kind;
    value.typed = std::move(typed);
    value.isShown = true;
    return value;
}

/// Two shown ones, one that is made of them, one that is not shown.
Values design()
{
    Values values;
    for (Value value : {shown(1, "width", "148 mm"), shown(2, "boards", "3", ValueKind::Count),
                        shown(3, "gap", "width/boards"), shown(4, "secret", "5 mm")}) {
        value.isShown = value.name != "secret";
        values.list.push_back(makeValue(std::move(value)));
    }
    return values;
}

Values typed(const Values &values, std::int64_t id, const char *text)
{
    return typedValue(values, ValueId{id}, text, {}).value();
}

std::string textOf(const Values &values, const char *name)
{
    return values.find(std::string_view(name))->typed;
}

/// What the header promises of all values, whatever was done to them.
bool isWhole(const Values &values)
{
    std::set<std::string> names;
    return std::all_of(
        values.presets.begin(), values.presets.end(), [&](const PresetPointer &preset) {
            const auto &settings = preset->settings;
            const bool isAscending = std::adjacent_find(settings.begin(), settings.end(),
                                                        [](const Setting &a, const Setting &b) {
                                                            return !(a.value < b.value);
                                                        }) == settings.end();
            return isPresetName(preset->name) && names.insert(preset->name).second &&
                   !settings.empty() && isAscending &&
                   std::all_of(settings.begin(), settings.end(), [&](const Setting &setting) {
                       return values.indexOf(setting.value) >= 0;
                   });
        });
}

} // namespace

class TestPresets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keptIsWhatCanBeSet();
    void takingBringsItBack();
    void alikeInAnotherUnit();
    void namesAreFoundWhateverTheirCapitals();
    void whatIsGoneIsDropped();
    void othersComeAlong();
    void anyEditLeavesThemWhole();
};

void TestPresets::keptIsWhatCanBeSet()
{
    const Preset preset = takenPreset(design(), "A5");
    QCOMPARE(preset.settings.size(), std::size_t(2));
    QCOMPARE(preset.settings[0], (Setting{ValueId{1}, "148 mm", {}}));
    QCOMPARE(preset.settings[1], (Setting{ValueId{2}, "3", {}}));
    QVERIFY(takenPreset(Values(), "A5").settings.empty());
}

void TestPresets::takingBringsItBack()
{
    Values values = withPreset(design(), takenPreset(design(), "A5"));
    const Values before = values;
    QCOMPARE(presetInUse(values)->name, std::string("A5"));
    values = typed(typed(values, 1, "210 mm"), 4, "6 mm");
    QVERIFY(!presetInUse(values));
    values = withPreset(values, takenPreset(values, "A4"));
    QCOMPARE(presetInUse(values)->name, std::string("A4"));
    const Values back = setByPreset(values, *findPreset(values, "A5"));
    QCOMPARE(textOf(back, "width"), std::string("148 mm"));
    QCOMPARE(textOf(back, "secret"), std::string("6 mm")); // none of its business
    QVERIFY(setByPreset(back, *findPreset(back, "A5")).isSame(back));
    // What it does not change stays the same object.
    QCOMPARE(back.list[1], before.list[1]);
    // A name is kept once, at its place.
    const Values again = withPreset(back, takenPreset(typed(back, 1, "150 mm"), "A5"));
    QCOMPARE(again.presets.size(), std::size_t(2));
    QCOMPARE(again.presets[0]->settings[0].typed, std::string("150 mm"));
    QCOMPARE(withoutPreset(again, "A5").presets.size(), std::size_t(1));
    QVERIFY(withoutPreset(again, "A6").isSame(again));
}

void TestPresets::alikeInAnotherUnit()
{
    const Values values = withPreset(design(), takenPreset(design(), "A5"));
    QVERIFY(presetInUse(typed(values, 1, "14.8 cm")));
    QVERIFY(!presetInUse(typed(values, 1, "14.81 cm")));
    QVERIFY(!presetInUse(typed(values, 1, "boards*1 mm")));
}

void TestPresets::namesAreFoundWhateverTheirCapitals()
{
    const Values values = withPreset(design(), takenPreset(design(), "Four shelves"));
    QVERIFY(findPreset(values, "four SHELVES"));
    QVERIFY(!findPreset(values, "four"));
    for (const char *name : {"", " A5", "A5 ", "a=b", "\tA5"})
        QVERIFY2(!isPresetName(name), name);
    QVERIFY(isPresetName("A5, wide"));
}

void TestPresets::whatIsGoneIsDropped()
{
    Values values = withPreset(design(), takenPreset(design(), "A5"));
    values = removedValue(values, ValueId{2}, EvaluatedValues::of(values)).values;
    QCOMPARE(values.presets[0]->settings.size(), std::size_t(1));
    Value width = *values.find(std::string_view("width"));
    width.kind = ValueKind::Mass;
    width.typed = "3 kg";
    QVERIFY(changedValue(values, width)->presets.empty());
    // Another range is none of its business.
    Value ranged = *values.find(std::string_view("width"));
    ranged.range.most = 300.0;
    QCOMPARE(changedValue(values, ranged)->presets, values.presets);
    QCOMPARE(renamedValue(values, ValueId{1}, "w")->presets, values.presets);
}

void TestPresets::othersComeAlong()
{
    const Values values = withPreset(design(), takenPreset(design(), "A5"));
    Values others = withPreset(design(), takenPreset(design(), "a5"));
    others = withPreset(others, takenPreset(others, "A4"));
    const ValueMerge merge = mergedValues(values, others, 100);
    QCOMPARE(merge.values.presets.size(), std::size_t(3));
    QCOMPARE(merge.values.presets[1]->name, std::string("a5 2"));
    QCOMPARE(merge.values.presets[1]->settings[0].value, merge.ids.at(ValueId{1}));
    QCOMPARE(merge.values.presets[2]->name, std::string("A4"));
    QVERIFY(isWhole(merge.values));
}

void TestPresets::anyEditLeavesThemWhole()
{
    std::mt19937 random(5);
    const auto upTo = [&random](int most) {
        return std::uniform_int_distribution<int>(0, most)(random);
    };
    Values values = design();
    std::int64_t nextId = 10;
    const int rounds = test::rounds(3000);
    for (int round = 0; round < rounds; ++round) {
        const ValueId id = values.list.empty() ? ValueId{1}
                                               : values
                                                     .list[static_cast<std::size_t>(upTo(
                                                         static_cast<int>(values.list.size()) - 1))]
                                                     ->value.id;
        const std::string name = "P" + std::to_string(upTo(5));
        switch (upTo(6)) {
        case 0:
            if (Preset preset = takenPreset(values, name); !preset.settings.empty())
                values = withPreset(values, std::move(preset));
            break;
        case 1:
            values = withoutPreset(values, name);
            break;
        case 2:
            if (const Preset *preset = findPreset(values, name)) {
                values = setByPreset(values, *preset);
                QVERIFY(presetInUse(values));
                const auto &settings = preset->settings;
                QVERIFY(std::all_of(settings.begin(), settings.end(), [&](const Setting &one) {
                    return EvaluatedValues::of(values).worth(one.value);
                }));
            }
            break;
        case 3:
            values =
                addedValue(values, shown(nextId, "v" + std::to_string(nextId), "7 mm")).value();
            ++nextId;
            break;
        case 4:
            if (values.list.size() > 3)
                values = removedValue(values, id, EvaluatedValues::of(values)).values;
            break;
        case 5:
            if (const Value *value = values.find(id)) {
                Value next = *value;
                next.kind = upTo(3) ? next.kind : upTo(1) ? ValueKind::Length : ValueKind::Count;
                next.typed = std::to_string(upTo(9) + 1);
                values = changedValue(values, next).value();
            }
            break;
        default:
            if (values.list.size() < 40) {
                const ValueMerge merge = mergedValues(values, values, nextId);
                nextId += std::ssize(values.list);
                values = merge.values;
            }
            break;
        }
        QVERIFY2(isWhole(values), qPrintable(QString::number(round)));
    }
}

FFF_TEST(TestPresets)
#include "tst_presets.moc"
