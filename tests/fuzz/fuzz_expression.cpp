// Any bytes as what a person typed where a value is wanted, as every kind, and as a list of values,
// one a line. If this stops, an expression in a file takes the window down, or what is written of
// one is another.
#include "core/base/utf8.h"
#include "core/values/value_edits.h"
#include "tests/fuzz/properties.h"

#include <cmath>

using namespace fff;

namespace {

constexpr std::size_t kMostLines = 40;

void requireClearHere(const ExpressionError &error, std::string_view text)
{
    fuzz::require(!error.message.isEmpty(), "an error has words");
    fuzz::require(error.place.begin <= error.place.end && error.place.end <= text.size(),
                  "the place of an error is in the text");
}

Worth one(Worth::Type type, double number, const char *text = "")
{
    return {type, {}, false, number, text};
}

const Worth *known(std::string_view name)
{
    static const Worth length{Worth::Type::Number, kLengthPowers, false, 12.0};
    static const Worth count = one(Worth::Type::Number, 5.0), truth = one(Worth::Type::Truth, 1.0),
                       word = one(Worth::Type::Text, 0.0, "word");
    return name == "a"   ? &length
           : name == "n" ? &count
           : name == "y" ? &truth
           : name == "w" ? &word
                         : nullptr;
}

void tryFormula(std::string_view text)
{
    const Understood<Formula> formula = Formula::read(text);
    if (!formula)
        return requireClearHere(formula.error(), text);
    // Long fractions may be longer when written out.
    const std::string written = writtenFormula(*formula);
    if (written.size() <= kLongestExpression) {
        const Understood<Formula> again = Formula::read(written);
        fuzz::require(again && again->means(*formula), "what is written is read as the same");
    }
    const Understood<Worth> worth = formula->worth(known);
    if (!worth)
        return requireClearHere(worth.error(), text);
    fuzz::require(worth->type != Worth::Type::Number || std::isfinite(worth->number),
                  "a number is finite");
}

void tryKind(std::string_view text, ValueKind kind)
{
    const Understood<Typed> typed = Typed::read(text, kind);
    if (!typed)
        return requireClearHere(typed.error(), text);
    fuzz::require(typed->text() == text, "what was typed stays");
    const Renames there{{"a", "other"}}, back{{"other", "a"}};
    const std::string other = renamedIn(text, kind, there);
    fuzz::require(renamedIn(text, kind, {{"a", "a"}}).size() == text.size(),
                  "a name in its own place changes no length");
    const Understood<Typed> renamed = Typed::read(other, kind);
    fuzz::require(renamed || other.size() > kLongestExpression, "with other names it is read, too");
    const Understood<Worth> worth = typed->worth(known);
    if (!worth)
        return requireClearHere(worth.error(), text);
    if (decoded(worth->text).size() > kLongestExpression)
        return;
    const Understood<Typed> exact = Typed::read(exactText(*worth, kind), kind);
    if (exact && exact->worth({}))
        fuzz::require(*exact->worth({}) == *worth, "a number in its place is the same");
}

void tryValues(std::string_view text)
{
    Values values;
    std::int64_t id = 0;
    while (!text.empty() && values.list.size() < kMostLines) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        Value value;
        value.id = ValueId{++id};
        value.name = "v" + std::to_string(id);
        value.kind = static_cast<ValueKind>(line.size() % 9);
        value.typed = line;
        values.list.push_back(makeValue(std::move(value)));
    }
    const EvaluatedValues all = EvaluatedValues::of(values);
    for (const ValuePointer &known : values.list)
        if (const ExpressionError *error = all.error(known->value.id))
            requireClearHere(*error, known->value.typed);
    if (values.list.empty())
        return;
    const ValueRemoval removal = removedValue(values, ValueId{1}, all);
    EvaluatedValues::of(removal.values, all);
    mergedValues(values, values, id + 1);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    tryFormula(bytes);
    for (int kind = 0; kind < 9; ++kind)
        tryKind(bytes, static_cast<ValueKind>(kind));
    tryValues(bytes);
    return 0;
}
