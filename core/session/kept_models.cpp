#include "core/session/kept_models.h"

#include "core/operations/evaluate.h"

#include <algorithm>

namespace fff {

namespace {

// What a node of a map or of shared ownership takes besides its value.
constexpr std::size_t kNode = 48;

template <class T>
std::size_t bytesOf(const std::vector<T> &values)
{
    return values.size() * sizeof(T);
}

std::size_t bytesOf(const Shape &shape)
{
    std::size_t bytes = sizeof(Shape) + kNode + bytesOf(shape.contour().points());
    for (const Contour &hole : shape.holes())
        bytes += sizeof(Contour) + bytesOf(hole.points());
    // The chords with their places on the curve, and as a region once more; it is there, since
    // whatever is shown of a section begins with it. Triangles have as many corners.
    const Region &region = shape.region();
    bytes += region.outer.size() * (sizeof(Vec2) + sizeof(CurvePoint));
    for (const Polygon *ring = &region.outer; ring;) {
        bytes += ring->size() * (2 * sizeof(Vec2) + sizeof(std::array<int, 3>));
        const auto next = ring == &region.outer ? 0 : ring - region.holes.data() + 1;
        ring = next < std::ssize(region.holes) ? &region.holes[static_cast<std::size_t>(next)]
                                               : nullptr;
    }
    return bytes;
}

std::size_t bytesOf(const Mark &mark)
{
    std::size_t bytes = sizeof(Mark) + kNode;
    for (const CurvePath &path : mark.paths)
        bytes += sizeof(CurvePath) + bytesOf(path.points());
    return bytes;
}

std::size_t bytesOf(const Section &section)
{
    return sizeof(Section) + kNode + section.name.capacity() + section.made.key.capacity() +
           bytesOf(section.figures) + bytesOf(section.marks);
}

std::size_t bytesOf(const OperationResult &result)
{
    std::size_t bytes = sizeof(OperationResult) + kNode + bytesOf(result.sections) +
                        bytesOf(result.changed) + bytesOf(result.notices) + bytesOf(result.track) +
                        bytesOf(result.readSections) + bytesOf(result.readStocks);
    bytes += result.images.size() * (kNode + sizeof(*result.images.begin()));
    bytes += result.mirrors.size() * (kNode + sizeof(*result.mirrors.begin()));
    bytes += result.found.size() * (kNode + sizeof(*result.found.begin()));
    return result.readAll ? bytes + bytesOf(*result.readAll) : bytes;
}

} // namespace

/// Calls visit(object, bytes) for what of a model hangs on its evaluation; where it says that the
/// object is known, not for what hangs on that.
template <class Visit>
void KeptModels::eachResult(const Model &model, Visit visit)
{
    const auto ofSection = [&visit](const SectionPointer &section) {
        if (!section || !visit(section.get(), [&] { return bytesOf(*section); }))
            return;
        visit(section->shape.get(), [&] { return bytesOf(*section->shape); });
        for (const MarkPointer &mark : section->marks)
            visit(mark.get(), [&] { return bytesOf(*mark); });
    };
    for (const OperationResultPointer &result : model.evaluation.results) {
        if (!visit(result.get(), [&] { return bytesOf(*result); }))
            continue;
        for (const SectionPointer &section : result->sections)
            ofSection(section);
        for (const auto &[ref, section] : result->changed)
            ofSection(section);
    }
    if (const auto &listing = model.evaluation.listing)
        visit(listing.get(), [&] {
            return sizeof(Listing) + kNode + bytesOf(listing->sections) + bytesOf(listing->blocks);
        });
    visit(&model, [&] { return sizeof(Model) + kNode + bytesOf(model.document.sections); });
}

void KeptModels::weigh(const Model &model)
{
    eachResult(model, [this](const void *object, auto bytes) {
        Weighed &weighed = m_weighed[object];
        if (weighed.uses++ > 0)
            return false;
        weighed.bytes = bytes();
        m_bytes += weighed.bytes;
        return true;
    });
}

void KeptModels::release(const Model &model)
{
    eachResult(model, [this](const void *object, auto) {
        const auto weighed = m_weighed.find(object);
        if (--weighed->second.uses > 0)
            return false;
        m_bytes -= weighed->second.bytes;
        m_weighed.erase(weighed);
        return true;
    });
}

void KeptModels::touch(const ModelPointer &model)
{
    const auto known = std::find_if(m_held.begin(), m_held.end(),
                                    [&](const Held &held) { return held.model == model; });
    if (known != m_held.end())
        m_held.splice(m_held.begin(), m_held, known);
    else
        m_held.push_front({model});
    // Weighed once another one is shown: by then it has what will be worked out of it.
    for (auto held = std::next(m_held.begin()); held != m_held.end() && !held->isWeighed; ++held) {
        weigh(*held->model);
        held->isWeighed = true;
    }
    if (Held &newest = m_held.front(); newest.isWeighed) {
        release(*newest.model);
        newest.isWeighed = false;
    }
    while (m_bytes > m_room && m_held.size() > 1) {
        release(*m_held.back().model);
        m_held.pop_back();
    }
}

KeptModelPointer KeptModels::keep(ModelPointer model)
{
    if (model->evaluation.results.empty() && !model->evaluation.listing)
        return std::make_shared<KeptModel>(KeptModel{model, model});
    touch(model);
    auto drawn = std::make_shared<const Model>(Model{model->document, {}});
    return std::make_shared<KeptModel>(KeptModel{std::move(drawn), model});
}

ModelPointer KeptModels::get(KeptModel &kept, const Model &near)
{
    ModelPointer model = kept.whole.lock();
    if (!model) {
        model = std::make_shared<const Model>(evaluate(kept.document(), near));
        kept.whole = model;
    }
    if (model != kept.drawn)
        touch(model);
    return model;
}

void KeptModels::clear()
{
    m_held.clear();
    m_weighed.clear();
    m_bytes = 0;
}

} // namespace fff
