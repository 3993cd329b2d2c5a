#include "core/fabrication/cut_section.h"

#include "core/base/tolerances.h"
#include "core/fabrication/kerf.h"
#include "core/geometry/notch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <list>
#include <unordered_map>

namespace fff {

namespace {

// Each costs some 100 kB with its triangles; a model of a few hundred sections and its undo steps
// fit.
constexpr std::size_t kMaxCutSections = 1024;

/// What a slit cuts: the rectangle, whatever joint it belongs to.
using SlitKey = std::array<double, 5>;

struct CutKey
{
    const Shape *shape = nullptr; // only as good as Entry::shape says
    std::vector<SlitKey> slits;

    bool operator==(const CutKey &) const = default;
};

struct CutKeyHash
{
    std::size_t operator()(const CutKey &key) const
    {
        constexpr std::size_t kMixer = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
        std::size_t hash = std::hash<const void *>()(key.shape);
        for (const SlitKey &slit : key.slits) {
            for (double value : slit)
                hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * kMixer;
        }
        return hash ^ (hash >> 32);
    }
};

CutKey makeKey(const Shape *shape, const std::vector<Slit> &slits)
{
    CutKey key{shape, {}};
    key.slits.reserve(slits.size());
    for (const Slit &s : slits)
        key.slits.push_back({s.inner.x(), s.inner.y(), s.mouth.x(), s.mouth.y(), s.width});
    return key;
}

std::vector<CurvedRegion> cutParts(const Shape &shape, const std::vector<Polygon> &cuts)
{
    if (shape.isPlain()) {
        if (auto part = cutNotches(shape.contour(), shape.chords(), shape.holes(), cuts, kCutChord))
            return {*std::move(part)};
    }
    return subtract(shape.contour(), shape.holes(), cuts, kCutChord);
}

} // namespace

CutSection::CutSection(std::vector<CurvedRegion> parts) : m_parts(std::move(parts)) {}

const std::vector<Triangulation> &CutSection::triangulations() const
{
    std::call_once(m_once, [this] {
        for (const CurvedRegion &part : m_parts)
            m_triangulations.push_back(triangulate(part.region));
    });
    return m_triangulations;
}

double CutSection::area() const
{
    double sum = 0.0;
    for (const CurvedRegion &part : m_parts) {
        sum += part.outer.signedArea();
        for (const Contour &hole : part.holes)
            sum += hole.signedArea();
    }
    return sum;
}

const Moments &CutSection::moments() const
{
    std::call_once(m_momentsOnce, [this] {
        for (const CurvedRegion &part : m_parts) {
            m_moments += fff::moments(part.outer);
            for (const Contour &hole : part.holes)
                m_moments += fff::moments(hole);
        }
    });
    return m_moments;
}

std::shared_ptr<const std::vector<CurvedRegion>> CutSection::compensated(double kerf) const
{
    const std::lock_guard lock(m_compensatedMutex);
    if (!m_compensated || m_compensatedKerf != kerf) {
        std::vector<CurvedRegion> parts;
        parts.reserve(m_parts.size());
        for (const CurvedRegion &part : m_parts)
            parts.push_back(compensateKerf(part, kerf));
        m_compensated = std::make_shared<const std::vector<CurvedRegion>>(std::move(parts));
        m_compensatedKerf = kerf;
    }
    return m_compensated;
}

struct CutCache::Data
{
    struct Entry
    {
        CutKey key;
        std::weak_ptr<const Shape> shape; // expired: the address may be another shape's by now
        CutSectionPointer cut;
    };

    std::list<Entry> entries; // most recently used first
    std::unordered_map<CutKey, std::list<Entry>::iterator, CutKeyHash> byKey;

    /// Null when it is not there.
    CutSectionPointer find(const CutKey &key)
    {
        const auto found = byKey.find(key);
        if (found == byKey.end())
            return nullptr;
        if (found->second->shape.expired()) {
            entries.erase(found->second);
            byKey.erase(found);
            return nullptr;
        }
        entries.splice(entries.begin(), entries, found->second);
        return found->second->cut;
    }

    void insert(Entry entry)
    {
        while (entries.size() >= kMaxCutSections) {
            byKey.erase(entries.back().key);
            entries.pop_back();
        }
        entries.push_front(std::move(entry));
        byKey.emplace(entries.front().key, entries.begin());
    }
};

CutCache::CutCache() : m_data(std::make_unique<Data>()) {}
CutCache::~CutCache() = default;
CutCache::CutCache(CutCache &&) noexcept = default;
CutCache &CutCache::operator=(CutCache &&) noexcept = default;

CutSectionPointer cutSection(const ShapePointer &shape, const std::vector<Slit> &slits,
                             CutCache &cache)
{
    CutKey key = makeKey(shape.get(), slits);
    if (CutSectionPointer known = cache.data().find(key))
        return known;
    std::vector<Polygon> cuts;
    cuts.reserve(slits.size());
    for (const Slit &slit : slits)
        cuts.push_back(slit.outline());
    auto cut = std::make_shared<const CutSection>(cutParts(*shape, cuts));
    cache.data().insert({std::move(key), shape, cut});
    return cut;
}

} // namespace fff
