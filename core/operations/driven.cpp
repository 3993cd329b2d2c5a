#include "core/operations/driven.h"

#include "core/values/expression_words.h"
#include "core/values/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace fff {

namespace {

//: %1: an expression, %2 what it comes to
constexpr Text kNotPossible = FFF_TEXT("Driven", "“%1” is %2, which is not possible here.");
//: %1: an expression
constexpr Text kDisagree =
    FFF_TEXT("Driven", "“%1” and another expression want this to be different at the same time.");
//: %1: what was typed, %2 a length or the like
constexpr Text kKept =
    FFF_TEXT("Driven", "“%1” is not possible here: numbers that follow values keep "
                       "it at %2.");
//: %1: what was typed, %2 names a number such as "Wheel, Diameter", %3: an expression
constexpr Text kKeptBy =
    FFF_TEXT("Driven", "“%1” is not possible here: %2 follows “%3”, which keeps it as it is.");
//: %1 is the name of a value
constexpr Text kHasNoWorth = FFF_TEXT("Driven", "“%1” cannot be worked out.");
//: %1: an expression
constexpr Text kIsEmpty = FFF_TEXT("Driven", "“%1” is empty, which is not possible here.");
constexpr Text kNoPlace = FFF_TEXT("Driven", "What this number belongs to is not there any more.");

/// A chain of sections on each other needs as many as it is long, where all have a place by
/// numbers; a length within another one that is hardly longer comes near it by a small share in
/// each.
constexpr int kMostRounds = 1000;
constexpr int kRoundsToJudge = 100;
constexpr double kNearer = 0.9;           // of what was apart as many rounds before
constexpr double kFarthest = 4.0;         // of all that lengths of a section change together
constexpr double kSameWorthLength = 1e-3; // mm

Message atPlace(const Document &document, const DrivenPlace &place, const Message &sentence)
{
    return {{nullptr, "%1: %2"}, {nameOf(document, place), sentence}};
}

/// Names are looked up where they are, however often the function is copied.
Names sharedNames(const EvaluatedValues &values)
{
    return [names = std::make_shared<const Names>(values.names())](
               std::string_view name) -> const Worth * { return (*names)(name); };
}

bool stillCounts(const Document &document, const Binding &binding)
{
    const std::optional<DrivenNumber> number = drivenNumber(document, binding.place);
    return number && number->kind == binding.kind && isSameWorth(number->worth, binding.result);
}

void endOthers(Document &document)
{
    const auto isOver = [&document](const BindingPointer &pointer) {
        return !stillCounts(document, pointer->binding);
    };
    if (std::any_of(document.bindings.begin(), document.bindings.end(), isOver)) {
        std::vector<BindingPointer> kept;
        for (const BindingPointer &pointer : document.bindings)
            if (!isOver(pointer))
                kept.push_back(pointer);
        document.bindings = std::move(kept);
    }
}

Message whyNotWritten(const Binding &binding, const Worth &worth, const Error &error)
{
    if (error.code != ErrorCode::BadValue)
        return {{nullptr, "%1"}, {error}};
    const Named typed = quoted(binding.typed, {0, binding.typed.size()});
    if (worth.type == Worth::Type::Text && worth.text.empty())
        return {kIsEmpty, {typed}};
    return {kNotPossible, {typed, argumentOf(worth)}};
}

/// The numbers of one document on their way to what was typed for them.
class Driver
{
public:
    Driver(Document document, Names names)
        : m_document(std::move(document)), m_before(m_document), m_bindings(m_document.bindings),
          m_names(std::move(names))
    {
    }

    /// Of all that have one; else until all agree.
    std::vector<DrivingError> drive()
    {
        workOut();
        for (int round = 0; m_errors.empty() && round < kMostRounds; ++round) {
            m_disagreeing = nullptr;
            m_refused.reset();
            m_isWritten = false;
            m_apart = 0.0;
            for (const BindingPointer &pointer : m_bindings)
                follow(*pointer);
            if (!m_disagreeing || !m_isWritten || !comesNearer(round))
                break;
        }
        if (m_errors.empty() && m_refused)
            m_errors.push_back(*std::move(m_refused));
        else if (m_errors.empty() && (m_disagreeing || strayed()))
            fail(m_disagreeing->place, {kDisagree, {quotedAll(*m_disagreeing)}});
        if (m_errors.empty())
            keepResults();
        return std::move(m_errors);
    }
    Document take() { return std::move(m_document); }

private:
    static Named quotedAll(const Binding &binding)
    {
        return quoted(binding.typed, {0, binding.typed.size()});
    }
    void fail(const DrivenPlace &place, const Message &sentence)
    {
        m_errors.push_back({place, atPlace(m_document, place, sentence)});
    }
    Understood<Worth> worthOf(const KnownBinding &known) const
    {
        if (!known.typed)
            return tl::unexpected(known.typed.error());
        return known.typed->worth(namesAt(m_document, known.binding.place, m_names));
    }
    /// All errors of expressions, not the first one alone.
    void workOut()
    {
        for (const BindingPointer &pointer : m_bindings) {
            const Understood<Worth> worth = worthOf(*pointer);
            if (worth)
                continue;
            const std::string wrong = wrongNameOf(*pointer);
            fail(pointer->binding.place,
                 wrong.empty() ? worth.error().message : Message{kHasNoWorth, {Named{wrong}}});
        }
    }
    /// Of a value that is there, and has no worth by now.
    std::string wrongNameOf(const KnownBinding &known) const
    {
        if (known.typed)
            for (const std::string &name : known.typed->names())
                if (m_document.values.find(std::string_view(name)) && !m_names(name))
                    return name;
        return {};
    }
    /// Asked now and then: two that want different things stay as far apart as they were.
    bool comesNearer(int round)
    {
        if (round % kRoundsToJudge != 0)
            return true;
        const double before = std::exchange(m_apartBefore, m_apart);
        return m_apart < kNearer * before;
    }
    void follow(const KnownBinding &known)
    {
        if (!m_errors.empty())
            return;
        const Binding &binding = known.binding;
        const Understood<Worth> worth = worthOf(known); // the thickness may be another one now
        const std::optional<DrivenNumber> number = drivenNumber(m_document, binding.place);
        if (!worth || !number) {
            fail(binding.place,
                 worth ? Message{kDisagree, {quotedAll(binding)}} : worth.error().message);
            return;
        }
        if (isSameWorth(number->worth, *worth))
            return;
        m_disagreeing = &binding;
        m_apart = std::max(m_apart, std::abs(number->worth.number - worth->number));
        Result<Document> next = withDrivenNumber(m_document, binding.place, *worth);
        // What has no room now may have it when others are where they go: a hole that grows before
        // the disc around it.
        if (next) {
            m_document = *std::move(next);
            m_isWritten = true;
        } else if (!m_refused) {
            m_refused = {binding.place, atPlace(m_document, binding.place,
                                                whyNotWritten(binding, *worth, next.error()))};
        }
    }
    /// Lengths that hardly go together can be made to by shearing the section away, round after
    /// round. None of its places has a reason to go farther than its lengths change together.
    bool strayed()
    {
        std::map<SectionId, double> changes;
        for (const BindingPointer &pointer : m_bindings) {
            const DrivenPlace &place = pointer->binding.place;
            const Dimension *dimension =
                place.of == DrivenPlace::Of::Dimension ? dimensionAt(place) : nullptr;
            const bool isSize = place.of == DrivenPlace::Of::Section &&
                                (place.field == "width" || place.field == "height");
            const std::optional<DrivenNumber> was = drivenNumber(m_before, place),
                                              is = drivenNumber(m_document, place);
            if ((!dimension && !isSize) || !was || !is)
                continue;
            const SectionId section =
                dimension ? dimension->from.section.drawn : SectionId{place.id};
            changes[section] += std::abs(is->worth.number - was->worth.number);
            if (dimension)
                m_disagreeing = &pointer->binding; // to be named
        }
        const bool isNamed = m_disagreeing != nullptr;
        const bool isFar =
            isNamed && std::any_of(changes.begin(), changes.end(), [this](const auto &change) {
                const Section *was = m_before.find(change.first);
                const Section *is = m_document.find(change.first);
                if (!was || !is || was->shape == is->shape)
                    return false;
                const Box2 before = was->shape->bounds(), now = is->shape->bounds();
                const double far = std::max((now.min - before.min).cwiseAbs().maxCoeff(),
                                            (now.max - before.max).cwiseAbs().maxCoeff());
                return far > kFarthest * change.second + kSameWorthLength;
            });
        if (!isFar)
            m_disagreeing = nullptr;
        return isFar;
    }
    const Dimension *dimensionAt(const DrivenPlace &place) const
    {
        for (const Dimension &dimension : m_document.dimensions)
            if (dimension.id.value == place.id)
                return &dimension;
        return nullptr;
    }
    void keepResults()
    {
        // Only a list that changes is another one.
        for (std::size_t i = 0; i < m_bindings.size(); ++i) {
            BindingPointer &pointer = m_document.bindings[i];
            Understood<Worth> worth = worthOf(*pointer);
            if (!worth || isSameWorth(*worth, pointer->binding.result))
                continue;
            Binding next = pointer->binding;
            next.result = *std::move(worth);
            pointer =
                std::make_shared<const KnownBinding>(KnownBinding{std::move(next), pointer->typed});
        }
    }

    Document m_document;
    const Document m_before;
    const std::vector<BindingPointer> m_bindings; // whatever becomes of those of the document
    Names m_names;
    std::vector<DrivingError> m_errors;
    // Of this round:
    const Binding *m_disagreeing = nullptr; // one that was not as it should be
    std::optional<DrivingError> m_refused;  // the first that could not be made so
    bool m_isWritten = false;               // one was made so
    double m_apart = 0.0;                   // of numbers, how far they were from it at most
    double m_apartBefore = std::numeric_limits<double>::infinity(); // some rounds ago
};

/// All numbers with bindings follow these, whatever they are now; or, with an error, none does.
void follow(Driven &result)
{
    Driver driver(result.document, sharedNames(result.values));
    result.errors = driver.drive();
    if (result.errors.empty())
        result.document = driver.take();
}

/// Null: none that was not there before.
const DrivingError *firstNew(const std::vector<DrivingError> &before,
                             const std::vector<DrivingError> &now)
{
    const auto found = std::find_if(now.begin(), now.end(), [&before](const DrivingError &error) {
        return std::find(before.begin(), before.end(), error) == before.end();
    });
    return found == now.end() ? nullptr : &*found;
}

} // namespace

Driven driven(Document document, const EvaluatedValues &previous)
{
    Driven result;
    result.values = EvaluatedValues::of(document.values, previous);
    result.document = std::move(document);
    if (result.document.bindings.empty())
        return result;
    endOthers(result.document);
    follow(result);
    return result;
}

tl::expected<Document, Message> bound(Document document, const DrivenPlace &place,
                                      std::string typed, const Reading &reading)
{
    const std::optional<DrivenNumber> number = drivenNumber(document, place);
    if (!number)
        return tl::unexpected(Message{kNoPlace, {}});
    const Understood<Typed> read = Typed::read(typed, number->kind, reading);
    if (!read)
        return tl::unexpected(atPlace(document, place, read.error().message));
    // What was wrong before is no reason against this one.
    const Driven before = driven(document);
    if (!read->isConstant()) {
        Driven agreed = driven(
            withBinding(document, {place, number->kind, std::move(typed), reading, number->worth}));
        if (const DrivingError *error = firstNew(before.errors, agreed.errors))
            return tl::unexpected(error->sentence);
        return std::move(agreed.document);
    }
    const Names none = [](std::string_view) -> const Worth * { return nullptr; };
    const Understood<Worth> worth = read->worth(none);
    if (!worth)
        return tl::unexpected(atPlace(document, place, worth.error().message));
    Result<Document> next = withDrivenNumber(withoutBinding(document, place), place, *worth);
    if (!next) {
        const Binding binding{place, number->kind, std::move(typed), reading, *worth};
        return tl::unexpected(
            atPlace(document, place, whyNotWritten(binding, *worth, next.error())));
    }
    // What this number moved, as a section takes along what is on it, is where it was meant to be.
    Driven result{*std::move(next), EvaluatedValues::of(document.values), {}};
    follow(result);
    const Named quote = quoted(typed, {0, typed.size()});
    if (const DrivingError *error = firstNew(before.errors, result.errors)) {
        const Binding *keeps = bindingOf(document, error->place);
        if (!keeps || error->place == place)
            return tl::unexpected(error->sentence);
        return tl::unexpected(atPlace(document, place,
                                      {kKeptBy,
                                       {quote, nameOf(document, error->place),
                                        quoted(keeps->typed, {0, keeps->typed.size()})}}));
    }
    const std::optional<DrivenNumber> is = drivenNumber(result.document, place);
    if (is && !isSameWorth(is->worth, *worth))
        return tl::unexpected(atPlace(document, place, {kKept, {quote, argumentOf(number->worth)}}));
    return std::move(result.document);
}

std::optional<Message> newlyWrong(const Document &before, const Document &after)
{
    const Driven was = driven(before), is = driven(after, was.values);
    for (const ValueId id : is.values.wrong())
        if (!was.values.error(id) || *was.values.error(id) != *is.values.error(id))
            return sentenceOf(*after.values.find(id), *is.values.error(id));
    const DrivingError *error = firstNew(was.errors, is.errors);
    return error ? std::optional(error->sentence) : std::nullopt;
}

} // namespace fff
