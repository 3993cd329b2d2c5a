#include "core/assembly/cut_section.h"

#include "core/base/tolerances.h"
#include "core/geometry/offset.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <list>
#include <optional>
#include <unordered_map>

namespace fff {

namespace {

// A model of a few hundred sections and its undo steps fit.
constexpr std::size_t kMostCuts = 1024;
// Weighing all is worth it when there is so much new, or a quarter of what there was.
constexpr std::size_t kManyCuts = 64;

// What an entry, a shared object, and where a slit goes through a boundary, take besides vectors.
constexpr std::size_t kEntryBytes = 256, kNotchBytes = 640;

template <class T>
std::size_t bytesOf(const std::vector<T> &values)
{
    return values.size() * sizeof(T);
}

std::size_t bytesOf(const CurvedRegion &part)
{
    std::size_t bytes = sizeof(CurvedRegion) + bytesOf(part.outer.points());
    for (const Contour &hole : part.holes)
        bytes += sizeof(Contour) + bytesOf(hole.points());
    bytes += bytesOf(part.region.outer);
    for (const Polygon &hole : part.region.holes)
        bytes += sizeof(Polygon) + bytesOf(hole);
    return bytes;
}

std::size_t bytesOf(const std::vector<CurvedRegion> &parts)
{
    std::size_t bytes = 0;
    for (const CurvedRegion &part : parts)
        bytes += bytesOf(part);
    return bytes;
}

struct CutKey
{
    const Shape *shape = nullptr; // only as good as Entry::shape says
    std::vector<SlitKey> slits;
    std::size_t hash = 0; // of the rest

    bool operator==(const CutKey &) const = default;
};

/// Of keys where they lie.
struct CutKeyHash
{
    std::size_t operator()(const CutKey *key) const { return key->hash; }
};
struct CutKeyEqual
{
    bool operator()(const CutKey *a, const CutKey *b) const { return *a == *b; }
};

SlitKey keyOf(const Slit &slit)
{
    return {{slit.inner.x(), slit.inner.y(), slit.mouth.x(), slit.mouth.y(), slit.width},
            slit.isOpen,
            slit.role,
            slit.form};
}

/// What of a form tells slits of one rectangle apart, enough for a hash.
std::array<double, 4> traitsOf(const SlitForm &form)
{
    return {static_cast<double>(form.end), form.radius, form.leadIns[0].from, form.bumps};
}

CutKey makeKey(const Shape *shape, const std::vector<Slit> &slits)
{
    constexpr std::size_t kMixer = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
    CutKey key{shape, {}, std::hash<const void *>()(shape)};
    key.slits.reserve(slits.size());
    for (const Slit &slit : slits) {
        key.slits.push_back(keyOf(slit));
        const auto mix = [&key](const auto &values) {
            for (const double value : values)
                key.hash = (key.hash ^ std::bit_cast<std::uint64_t>(value)) * kMixer;
        };
        mix(key.slits.back().rectangle);
        if (slit.form)
            mix(traitsOf(*slit.form));
    }
    key.hash ^= key.hash >> 32;
    return key;
}

/// The notch of a slit that was cut before, at the same place counted from either end: most edits
/// move some slits, put one in or take one out. Null for one that is new.
NotchPointer knownNotch(const std::vector<SlitNotch> &known, const SlitKey &slit, std::size_t index,
                        std::size_t count)
{
    for (const std::size_t at : {index, index + known.size() - count})
        if (at < known.size() && known[at].slit == slit)
            return known[at].notch;
    return nullptr;
}

NotchPointer findNotch(const NotchFinder &finder, const Slit &slit)
{
    if (slit.role == SlitRole::Tab)
        return nullptr;
    if (!slit.form)
        return finder.find(slit.outline());
    const std::vector<Contour> cuts = slit.cuts();
    return cuts.size() == 1 ? finder.find(cuts.front(), kCutChord) : nullptr;
}

/// Empty where one of the slits is none.
std::vector<SlitNotch> findNotches(const Shape &shape, const std::vector<Slit> &slits,
                                   const std::vector<SlitNotch> &known)
{
    std::vector<SlitNotch> notches;
    notches.reserve(slits.size());
    std::optional<NotchFinder> finder;
    for (const Slit &slit : slits) {
        const SlitKey key = keyOf(slit);
        NotchPointer notch = knownNotch(known, key, notches.size(), slits.size());
        if (!notch) {
            if (!finder)
                finder.emplace(shape.contour(), shape.chords());
            notch = findNotch(*finder, slit);
        }
        if (!notch)
            return {};
        notches.push_back({key, std::move(notch)});
    }
    return notches;
}

/// All that the slits cut.
std::vector<Contour> cutsOf(const std::vector<Slit> &slits)
{
    std::vector<Contour> all;
    all.reserve(slits.size());
    for (const Slit &slit : slits) {
        std::vector<Contour> cuts = slit.cuts();
        std::move(cuts.begin(), cuts.end(), std::back_inserter(all));
    }
    return all;
}

/// Pieces that do not overlap, and the tabs that are added to them.
Result<std::vector<CurvedRegion>> withTabs(std::vector<CurvedRegion> pieces,
                                           const std::vector<Slit> &slits, double chord)
{
    std::vector<Contour> all;
    for (const Slit &slit : slits)
        if (slit.role == SlitRole::Tab)
            all.push_back(Contour::ofPolygon(slit.outline()));
    if (all.empty())
        return pieces;
    for (CurvedRegion &piece : pieces) {
        all.push_back(std::move(piece.outer));
        std::move(piece.holes.begin(), piece.holes.end(), std::back_inserter(all));
    }
    return windingRegions(all, WindingRule::Positive, chord);
}

Result<CutSection::Paths> compensatedParts(const std::vector<CurvedRegion> &parts, double kerf)
{
    std::vector<CurvedRegion> paths;
    paths.reserve(parts.size());
    for (const CurvedRegion &part : parts) {
        Result<CurvedRegion> path = grow(part, 0.5 * kerf);
        if (!path)
            return tl::unexpected(std::move(path.error()));
        paths.push_back(std::move(*path));
    }
    return std::make_shared<const std::vector<CurvedRegion>>(std::move(paths));
}

} // namespace

Result<std::vector<CurvedRegion>> cutShape(const Shape &shape, const std::vector<Slit> &slits,
                                           double chord)
{
    Result<std::vector<CurvedRegion>> pieces =
        subtractContours(shape.contour(), shape.holes(), cutsOf(slits), chord);
    return pieces ? withTabs(*std::move(pieces), slits, chord) : pieces;
}

CutSection::CutSection(std::vector<CurvedRegion> parts) : m_parts(std::move(parts))
{
    sortOutWaste();
}

/// Parts come the largest first.
void CutSection::sortOutWaste()
{
    const auto isWaste = [](const CurvedRegion &part) {
        return std::abs(part.outer.signedArea()) < kWasteArea;
    };
    while (m_parts.size() > 1 && isWaste(m_parts.back())) {
        m_waste.push_back(m_parts.back().outer.points().front());
        m_parts.pop_back();
    }
}

CutSection::CutSection(const Shape &shape, const std::vector<Slit> &slits, const CutSection *before)
{
    static const std::vector<SlitNotch> none;
    if (shape.isPlain()) {
        m_notches = findNotches(shape, slits, before ? before->m_notches : none);
        std::vector<NotchPointer> notches;
        notches.reserve(m_notches.size());
        for (const SlitNotch &known : m_notches)
            notches.push_back(known.notch);
        if (m_notches.size() == slits.size()) {
            if (auto part = cutNotches(shape.contour(), shape.chords(), shape.holes(), notches,
                                       kCutChord)) {
                m_parts.push_back(*std::move(part));
                return;
            }
        }
    }
    Result<std::vector<CurvedRegion>> parts = cutShape(shape, slits, kCutChord);
    if (parts) {
        m_parts = *std::move(parts);
        sortOutWaste();
    } else {
        m_failure = parts.error();
        m_parts.push_back({shape.contour(), shape.holes(), shape.region()});
    }
}

const Result<std::vector<Triangulation>> &CutSection::triangulations() const
{
    m_once.run([this] {
        std::size_t bytes = 0;
        for (const CurvedRegion &part : m_parts) {
            Result<Triangulation> made = triangulate(part.region);
            if (!made) {
                m_triangulations = tl::unexpected(made.error());
                return;
            }
            bytes += sizeof(*made) + bytesOf(made->points) + bytesOf(made->triangles);
            m_triangulations->push_back(*std::move(made));
        }
        m_triangleBytes = bytes;
    });
    return m_triangulations;
}

const std::vector<RegionTree> &CutSection::trees() const
{
    m_treesOnce.run([this] {
        for (const CurvedRegion &part : m_parts)
            m_trees.emplace_back(part.region);
        // A box for every eight edges, and for every eight of these.
        m_treeBytes = bytesOf(m_parts) / sizeof(Vec2) * sizeof(Box2) / 7;
    });
    return m_trees;
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
    m_momentsOnce.run([this] {
        for (const CurvedRegion &part : m_parts) {
            m_moments += fff::moments(part.outer);
            for (const Contour &hole : part.holes)
                m_moments += fff::moments(hole);
        }
    });
    return m_moments;
}

Result<CutSection::Paths> CutSection::compensated(double kerf) const
{
    const std::lock_guard lock(m_compensatedMutex);
    if ((m_compensated && !*m_compensated) || m_compensatedKerf != kerf) {
        m_compensated = compensatedParts(m_parts, kerf);
        m_compensatedBytes = m_compensated ? bytesOf(**m_compensated) : 0;
        m_compensatedKerf = kerf;
    }
    return m_compensated;
}

std::size_t CutSection::bytes() const
{
    return sizeof(*this) + bytesOf(m_parts) + m_notches.size() * (sizeof(SlitNotch) + kNotchBytes) +
           m_triangleBytes + m_treeBytes + m_compensatedBytes;
}

struct CutCache::Data
{
    struct Entry
    {
        CutKey key;
        std::weak_ptr<const Shape> shape; // expired: the address may be another shape's by now
        CutSectionPointer cut;
    };

    std::size_t room = kRoom, most = kMostCuts;
    std::size_t added = 0;    // since it was trimmed
    std::list<Entry> entries; // most recently used first
    std::unordered_map<const CutKey *, std::list<Entry>::iterator, CutKeyHash, CutKeyEqual> byKey;

    /// Null when it is not there.
    CutSectionPointer find(const CutKey &key)
    {
        const auto found = byKey.find(&key);
        if (found == byKey.end())
            return nullptr;
        if (found->second->shape.expired()) {
            drop(found->second);
            return nullptr;
        }
        entries.splice(entries.begin(), entries, found->second);
        return found->second->cut;
    }

    void insert(Entry entry)
    {
        while (entries.size() >= most)
            drop(std::prev(entries.end()));
        if (++added > std::max(kManyCuts, entries.size() / 4))
            trim();
        entries.push_front(std::move(entry));
        byKey.emplace(&entries.front().key, entries.begin());
    }

    void trim()
    {
        added = 0;
        std::size_t bytes = 0;
        for (auto entry = entries.begin(); entry != entries.end();) {
            bytes += kEntryBytes + bytesOf(entry->key.slits);
            if (!entry->shape.expired() && (bytes += entry->cut->bytes()) <= room) {
                ++entry;
                continue;
            }
            entry = drop(entry);
        }
    }

    std::list<Entry>::iterator drop(std::list<Entry>::iterator entry)
    {
        byKey.erase(&entry->key);
        return entries.erase(entry);
    }
};

CutCache::CutCache(std::size_t room) : m_data(std::make_unique<Data>())
{
    m_data->room = room;
}
CutCache::~CutCache() = default;
CutCache::CutCache(CutCache &&) noexcept = default;
CutCache &CutCache::operator=(CutCache &&) noexcept = default;

void CutCache::trim(std::size_t sections)
{
    m_data->most = std::max(kMostCuts, 2 * sections);
    // Looking at each costs more than a small edit of a large model.
    if (m_data->added > std::max(kManyCuts, m_data->entries.size() / 4))
        m_data->trim();
}

CutSectionPointer cutSection(const ShapePointer &shape, const std::vector<Slit> &slits,
                             CutCache &cache, const CutSection *before)
{
    CutKey key = makeKey(shape.get(), slits);
    if (CutSectionPointer known = cache.data().find(key))
        return known;
    auto cut = std::make_shared<const CutSection>(*shape, slits, before);
    cache.data().insert({std::move(key), shape, cut});
    return cut;
}

} // namespace fff
