#include "core/analysis/suggesting/suggestion.h"

#include "core/analysis/suggesting/suggested_base.h"
#include "core/analysis/suggesting/suggestion_judge.h"
#include "core/base/tolerances.h"
#include "core/model/naming.h"
#include "core/model/template_edits.h"
#include "core/operations/seeded.h"

#include <algorithm>
#include <cmath>

#include <deque>
#include <iterator>
#include <optional>
#include <queue>
#include <set>
#include <string>

namespace fff {

namespace {

/// mm², times the square of the thickness: what is smaller holds no slit.
constexpr double kLeastPieceArea = 50.0;
/// So many cuts in a row are given to the judge before there is said to be none.
constexpr int kMostRefused = 40;

// Shares of the work.
constexpr double kSampled = 0.1, kCut = 0.5;

/// By so much the seed makes more or less of a cut.
constexpr double kWhim = 0.1;
/// Of planes that are parallel to the first ones: times the thickness, of the size; by how much
/// they are preferred.
constexpr double kLikeStep = 1.0, kLeastLikeStep = 0.0125, kLikePreference = 1.8;
/// Times the thickness: a plane so far within a flat face leaves strong walls beside its slits.
constexpr double kWithinFace = 1.2;
/// What leaves thin walls beside slits counts so much less.
constexpr double kWeakPreference = 0.35;
/// Planes are looked for anew where those that there are, are used up.
constexpr int kMostRounds = 6;
/// In so many of these all walls beside slits have to be strong.
constexpr int kStrongRounds = 3;

constexpr Text kTooSmall =
    //: %1 is the name of a template, %2 a length
    FFF_TEXT("Suggestion", "%1 is too small or too thin for sections that are %2 thick.");
constexpr Text kNoneStands =
    //: %1 is the name of a template
    FFF_TEXT("Suggestion", "No sections of %1 were found that hold each other and stand.");
constexpr Text kNoneFits =
    //: %1 is the name of a template
    FFF_TEXT("Suggestion",
             "No further section of %1 was found that fits among those that are there.");
constexpr Text kFewer =
    //: %1 is the name of a template
    FFF_TEXT_OF_MANY("Suggestion", "Only %n sections of %1 were found: any more would be in the "
                                   "way of these, or be held by none.");
constexpr Text kFewest =
    //: %1 is the name of a template
    FFF_TEXT_OF_MANY("Suggestion", "%n sections of %1 are the fewest that were found to stand.");
constexpr Text kLowered =
    //: %1 is the name of a template, %2 a length
    FFF_TEXT("Suggestion",
             "%1 was lowered into the ground by %2, so that its sections stand on a flat foot.");
constexpr Text kFooted =
    //: %1 is the name of a template, %2 and %3 are lengths
    FFF_TEXT("Suggestion", "%1 was lowered into the ground by %2, and its sections have feet up to "
                           "%3 high, so that they stand.");

Box3 boundsOf(const std::vector<Vec3> &points)
{
    Box3 box;
    for (const Vec3 &p : points)
        box.extend(p);
    return box;
}

class Suggester
{
public:
    Suggester(const Model &model, TemplatePointer subject, const SuggestionOptions &options,
              const LongWork &work)
        : m_model(model), m_subject(std::move(subject)), m_options(options), m_work(work),
          m_thickness(model.document.find(model.document.currentStock)->thickness)
    {
        const Similarity toWorld = worldPlacement(*m_subject, *m_subject->mesh);
        for (const Vec3 &p : m_subject->mesh->mesh->positions())
            m_positions.push_back(toWorld(p));
        m_box = boundsOf(m_positions);
        m_ground.level = m_box.min.y();
        m_firstNumber = freeNumbers();
    }

    Result<Suggestion> suggest();

private:
    std::size_t freeNumbers() const;
    LongWork part(double from, double to) const;
    Document withoutOthers();
    std::vector<SuggestedPlane> planesOf(int round) const;
    std::vector<SuggestedPlane> planesLikeThese(int round) const;
    Result<void> findCuts(const std::vector<SuggestedPlane> &planes, const LongWork &work);
    Result<NewSection> sectionOf(std::size_t cut, const SuggestedGround &ground,
                                 std::size_t number) const;
    SuggestionJudge::Verdict take(const std::vector<std::size_t> &cuts,
                                  const SuggestedGround &ground, bool allowsThinWalls);
    bool begin();
    void weaken(std::size_t cut);
    bool addNext();
    Result<Suggestion> suggestion() const;
    std::vector<Message> messages() const;

    const Model &m_model;
    TemplatePointer m_subject;
    const SuggestionOptions &m_options;
    const LongWork &m_work;
    double m_thickness;
    SuggestedGround m_ground; // where the template is now
    std::vector<Vec3> m_positions;
    Box3 m_box;
    std::size_t m_firstNumber = 1; // in the names of those that come

    std::optional<FormSamples> m_samples;
    std::deque<SuggestedCut> m_cuts;
    std::vector<double> m_gains;       // of each cut as last known: it can only have become less
    std::vector<char> m_isOut;         // taken, or in the way for good
    std::vector<char> m_isWeak;        // it leaves thin walls beside slits
    bool m_allowsWeak = false;         // nothing else came any more
    std::deque<SuggestedCut> m_before; // sections that are there
    std::optional<ShownForm> m_shown;
    std::optional<SuggestedGroup> m_group;
    std::optional<SuggestionJudge> m_judge;
    std::vector<NewSection> m_sections;
};

/// From here on no section is called by the template's name and a number.
std::size_t Suggester::freeNumbers() const
{
    std::set<std::string> names;
    for (const SectionPointer &section : m_model.sections())
        names.insert(section->name);
    std::size_t first = 1;
    for (std::size_t number = 1; number < first + kMostSuggested; ++number)
        if (names.contains(numberedName(m_subject->name, number)))
            first = number + 1;
    return first;
}

LongWork Suggester::part(double from, double to) const
{
    return {m_work.stop,
            [this, from, to](double share) { m_work.tell(from + share * (to - from)); }};
}

/// The document with only those sections that are where the template is.
Document Suggester::withoutOthers()
{
    std::vector<SectionId> others;
    for (const SectionPointer &section : m_model.sections()) {
        if (worldBounds(*section->shape, section->frame).intersects(m_box))
            m_before.push_back(cutOfSection(*section, kCutError * m_box.size().maxCoeff()));
        else if (section->id.isValid())
            others.push_back(section->id);
    }
    const Document &document = m_model.document;
    return document.operations.empty() ? removeSections(document, others).value_or(document)
                                       : document;
}

std::vector<SuggestedPlane> Suggester::planesOf(int round) const
{
    const auto shift = 0x9e3779b97f4a7c15ull * static_cast<std::uint64_t>(round);
    return suggestedPlanes(m_positions, *m_samples, kWithinFace * m_thickness, round > 0,
                           m_options.seed + shift);
}

/// Many that are parallel to those that are there: these get in nobody's way.
std::vector<SuggestedPlane> Suggester::planesLikeThese(int round) const
{
    // Those of each round are between those of the rounds before.
    constexpr double kFirst = 0.5, kGolden = 0.6180339887498949;
    const double share = std::fmod(kFirst + round * kGolden, 1.0);
    std::vector<Vec3> normals;
    for (const NewSection &section : m_sections) {
        const Vec3 normal = section.frame.normal();
        if (std::none_of(normals.begin(), normals.end(), [&](const Vec3 &known) {
                return known.cross(normal).norm() < kSameDirection;
            }))
            normals.push_back(normal);
    }
    std::vector<SuggestedPlane> planes;
    const double step = std::max(kLikeStep * m_thickness, kLeastLikeStep * m_samples->meshSize());
    for (const Vec3 &normal : normals)
        for (const SuggestedPlane &plane :
             planesAcross(normal, m_positions, step, share, kLikePreference))
            planes.push_back(plane);
    return planes;
}

Result<void> Suggester::findCuts(const std::vector<SuggestedPlane> &planes, const LongWork &work)
{
    const double least = kLeastPieceArea * m_thickness * m_thickness;
    Result<std::vector<SuggestedCut>> cuts =
        suggestedCuts(*m_subject, planes, *m_samples, least, work);
    if (!cuts)
        return tl::unexpected(std::move(cuts.error()));
    Seeded dice(m_options.seed, std::to_string(m_cuts.size()));
    for (SuggestedCut &cut : *cuts) {
        cut.preference *= 1.0 + kWhim * dice.symmetric();
        m_gains.push_back(cut.preference * m_shown->gainOf(cut.shown));
        m_isOut.push_back(0);
        m_isWeak.push_back(0);
        m_cuts.push_back(std::move(cut));
    }
    return {};
}

Result<NewSection> Suggester::sectionOf(std::size_t cut, const SuggestedGround &ground,
                                        std::size_t number) const
{
    NewSection section;
    section.name = numberedName(m_subject->name, number);
    section.frame = m_cuts[cut].frame;
    section.frame.origin.y() -= ground.level - m_box.min.y();
    Result<ShapePointer> shape = shapeOf(m_cuts[cut], *m_subject, ground);
    if (!shape)
        return tl::unexpected(std::move(shape.error()));
    section.shape = *std::move(shape);
    return section;
}

/// They come to those that are there, or nothing changes.
SuggestionJudge::Verdict Suggester::take(const std::vector<std::size_t> &cuts,
                                         const SuggestedGround &ground, bool allowsThinWalls)
{
    using Verdict = SuggestionJudge::Verdict;
    std::vector<NewSection> sections;
    for (const std::size_t cut : cuts) {
        Result<NewSection> section =
            sectionOf(cut, ground, m_firstNumber + m_sections.size() + sections.size());
        if (!section)
            return Verdict::Refused;
        sections.push_back(*std::move(section));
    }
    if (m_work.isStopped())
        return Verdict::Refused;
    if (const Verdict verdict = m_judge->take(sections, allowsThinWalls); verdict != Verdict::Taken)
        return verdict;
    for (const std::size_t cut : cuts) {
        m_group->add(m_cuts[cut]);
        m_shown->add(m_cuts[cut].shown);
        m_isOut[cut] = 1;
    }
    std::move(sections.begin(), sections.end(), std::back_inserter(m_sections));
    return Verdict::Taken;
}

/// The first few, where there are none to join.
bool Suggester::begin()
{
    if (!m_before.empty())
        return true;
    const double low = m_box.min.y();
    const auto accepts = [&](const SuggestedBase &base) {
        return take(base.cuts, base.ground, m_allowsWeak) == SuggestionJudge::Verdict::Taken;
    };
    const std::optional<SuggestedBase> base =
        suggestedBase(m_cuts, *m_samples, m_thickness, low, m_box.max.y() - low, m_allowsWeak,
                      accepts, m_work.stop);
    if (base)
        m_ground = base->ground;
    return base.has_value();
}

/// It leaves thin walls: others come first.
void Suggester::weaken(std::size_t cut)
{
    m_isWeak[cut] = 1;
    m_cuts[cut].preference *= kWeakPreference;
    m_gains[cut] *= kWeakPreference;
}

/// Of all that fit, the one that shows most of what is not shown yet.
bool Suggester::addNext()
{
    using Bound = std::pair<double, std::size_t>; // at most what it shows; of equals the later one
    std::priority_queue<Bound> open;
    for (std::size_t i = 0; i < m_cuts.size(); ++i)
        if (!m_isOut[i])
            open.emplace(m_gains[i], i);
    int refused = 0;
    while (!open.empty() && refused < kMostRefused && !m_work.isStopped()) {
        const std::size_t cut = open.top().second;
        open.pop();
        const double gain = m_cuts[cut].preference * m_shown->gainOf(m_cuts[cut].shown);
        m_gains[cut] = gain;
        if (!open.empty() && gain < open.top().first) {
            open.emplace(gain, cut);
            continue;
        }
        const SuggestedGroup::Fit fit = m_group->fitOf(m_cuts[cut]);
        m_isOut[cut] = fit == SuggestedGroup::Fit::InTheWay;
        if (fit == SuggestedGroup::Fit::InTheWay || fit == SuggestedGroup::Fit::Loose)
            continue;
        if (fit == SuggestedGroup::Fit::Weak && !m_isWeak[cut])
            weaken(cut);
        if (m_isWeak[cut] && !m_allowsWeak)
            continue;
        if (m_before.empty() && !m_group->isSteadyWith(m_cuts[cut], m_ground))
            continue; // it may, once there is something on the other side
        switch (take({cut}, m_ground, m_isWeak[cut] != 0)) {
        case SuggestionJudge::Verdict::Taken:
            return true;
        case SuggestionJudge::Verdict::Weak:
            weaken(cut);
            if (m_allowsWeak)
                open.emplace(m_gains[cut], cut);
            break;
        case SuggestionJudge::Verdict::Refused:
            m_isOut[cut] = 1;
            ++refused;
        }
    }
    return false;
}

std::vector<Message> Suggester::messages() const
{
    const Named name{m_subject->name};
    std::vector<Message> all;
    if (m_cuts.empty())
        all.push_back({kTooSmall, {name, lengthOf(m_thickness)}});
    else if (m_sections.empty())
        all.push_back({m_before.empty() ? kNoneStands : kNoneFits, {name}});
    else if (static_cast<int>(m_sections.size()) < m_options.count)
        all.push_back({kFewer, {name}, static_cast<int>(m_sections.size())});
    else if (static_cast<int>(m_sections.size()) > m_options.count)
        all.push_back({kFewest, {name}, static_cast<int>(m_sections.size())});
    const double lowered = m_ground.level - m_box.min.y();
    if (!m_sections.empty() && m_ground.filled > 0.0)
        all.push_back({kFooted, {name, lengthOf(lowered), lengthOf(m_ground.filled)}});
    else if (!m_sections.empty() && lowered > 0.0)
        all.push_back({kLowered, {name, lengthOf(lowered)}});
    return all;
}

Result<Suggestion> Suggester::suggestion() const
{
    Suggestion made{m_model.document, {}, 0.0, messages()};
    if (m_sections.empty())
        return made;
    made.lowered = m_ground.level - m_box.min.y();
    Result<Document> next = addSections(m_model.document, m_sections);
    // The ids are the judge's.
    for (const JointOverridePointer &wanted : m_judge->document().jointOverrides)
        if (next && !m_model.document.jointOverride(wanted->a, wanted->b))
            next = setJointOverride(*std::move(next), *wanted);
    if (next && made.lowered > 0.0) {
        Template lower = *m_subject;
        lower.frame.origin.y() -= made.lowered;
        next = setTemplate(*std::move(next), std::move(lower));
    }
    if (!next)
        return tl::unexpected(std::move(next.error()));
    made.document = *std::move(next);
    const std::vector<SectionPointer> &all = made.document.sections;
    for (std::size_t i = all.size() - m_sections.size(); i < all.size(); ++i)
        made.sections.push_back(all[i]->id);
    return made;
}

Result<Suggestion> Suggester::suggest()
{
    Result<FormSamples> samples =
        FormSamples::of(m_positions, m_subject->mesh->mesh->triangles(), part(0.0, kSampled));
    if (!samples)
        return tl::unexpected(std::move(samples.error()));
    m_samples = *std::move(samples);
    m_shown.emplace(*m_samples);
    m_group.emplace(m_thickness);
    m_judge.emplace(withoutOthers(), m_work.stop);
    for (const SuggestedCut &section : m_before) {
        m_shown->add(
            m_samples->shownBy(pointsAlong(section.frame, section.region, m_samples->step())));
        m_group->add(section);
    }
    if (const Result<void> found = findCuts(planesOf(0), part(kSampled, kCut)); !found)
        return tl::unexpected(found.error());
    bool hasBegun = false;
    for (int round = 1; static_cast<int>(m_sections.size()) < m_options.count;) {
        if (!hasBegun ? begin() : addNext()) {
            if (!hasBegun && !findCuts(planesLikeThese(0), {m_work.stop, {}}))
                break;
            hasBegun = true;
            m_work.tell(kCut + (1.0 - kCut) * std::min(1.0, static_cast<double>(m_sections.size()) /
                                                                m_options.count));
            continue;
        }
        m_allowsWeak = round >= kStrongRounds;
        if (round == kMostRounds || m_cuts.empty() || m_work.isStopped() ||
            !findCuts(planesOf(round), {m_work.stop, {}}) ||
            !findCuts(planesLikeThese(round), {m_work.stop, {}}))
            break;
        ++round;
    }
    if (m_work.isStopped())
        return failure(ErrorCode::Cancelled);
    return suggestion();
}

} // namespace

Result<Suggestion> suggestSections(const Model &model, TemplateId of,
                                   const SuggestionOptions &options, const LongWork &work)
{
    const auto &all = model.document.templates;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [of](const TemplatePointer &one) { return one->id == of; });
    if (found == all.end() || !(*found)->mesh)
        return failure(ErrorCode::UnknownReference, std::to_string(of.value),
                       {std::to_string(of.value)});
    if (options.count < 1 || options.count > kMostSuggested)
        return failure(ErrorCode::BadValue, "count",
                       {std::to_string(options.count), "a number from 1 to 100"});
    return Suggester(model, *found, options, work).suggest();
}

} // namespace fff
