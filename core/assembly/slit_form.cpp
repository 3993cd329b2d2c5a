#include "core/assembly/slit_form.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr double kPi = std::numbers::pi;
/// A dogbone's arc of this, of half of the slit's width, touches the other wall.
const double kWidest = 2.0 / (1.0 + std::numbers::sqrt2 / 2.0);
/// Half of a bump's length, of its height.
constexpr double kBumpHalf = 5.0;
/// Of the slit's width that one bump is high, and of the straight wall that it is long, at most.
constexpr double kBumpHeightShare = 0.25;
constexpr double kBumpLengthShare = 0.8;

/// A chain of lines and arcs under construction.
struct Chain
{
    Vec2 start = Vec2::Zero(), end = Vec2::Zero();
    std::vector<CubicBezier> segments;

    explicit Chain(const Vec2 &from) : start(from), end(from) {}

    void lineTo(const Vec2 &to)
    {
        if (!segments.empty() && (to - end).norm() <= kClipGrid) {
            segments.back().p3 = end = to;
            return;
        }
        segments.push_back(CubicBezier::line(end, to));
        end = to;
    }
    /// From `from` to `to` on a circle, radians; ends exactly at `last`.
    void arcTo(const Vec2 &centre, double radius, double from, double to, const Vec2 &last)
    {
        // A cubic for a quarter of a circle is off it, outwards, by 0.03 % of the radius.
        const int count = std::max(
            1, static_cast<int>(std::ceil((std::abs(to - from) - kSameDirection) / kPi * 2.0)));
        const double step = (to - from) / count;
        const double handle = 4.0 / 3.0 * std::tan(0.25 * step) * radius;
        const auto direction = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
        for (int i = 0; i < count; ++i) {
            const double a = from + i * step, b = from + (i + 1) * step;
            const Vec2 next = i + 1 == count ? last : Vec2(centre + radius * direction(b));
            segments.push_back({end, end + handle * perpendicular(direction(a)),
                                next - handle * perpendicular(direction(b)), next});
            end = next;
        }
    }
    void append(const Chain &other)
    {
        lineTo(other.start);
        segments.insert(segments.end(), other.segments.begin(), other.segments.end());
        end = other.end;
    }
    /// Backwards, and each point moved by the map.
    template <class Map>
    Chain reversed(Map map) const
    {
        Chain chain(map(end));
        for (auto it = segments.rbegin(); it != segments.rend(); ++it)
            chain.segments.push_back({map(it->p3), map(it->p2), map(it->p1), map(it->p0)});
        chain.end = map(start);
        return chain;
    }
    template <class Map>
    Chain mapped(Map map) const
    {
        Chain chain(map(start));
        for (const CubicBezier &s : segments)
            chain.segments.push_back({map(s.p0), map(s.p1), map(s.p2), map(s.p3)});
        chain.end = map(end);
        return chain;
    }
};

/// From the bottom, or from where its two arcs meet in the middle, round the corner to the wall at
/// y = half.
Chain endChain(SlitEnd end, double r, double half)
{
    switch (end) {
    case SlitEnd::Square:
        break;
    case SlitEnd::Round: {
        Chain chain(Vec2(-r, half - r));
        chain.arcTo({0.0, half - r}, r, kPi, 0.5 * kPi, {0.0, half});
        return chain;
    }
    case SlitEnd::Dogbone: {
        const double side = r * std::numbers::sqrt2 / 2.0;
        const Vec2 centre(side, half - side);
        const bool isFlat = half >= 2.0 * side;
        const double from = isFlat ? 1.25 * kPi : kPi + std::asin(centre.y() / r);
        Chain chain(isFlat ? Vec2(0.0, half - 2.0 * side) : Vec2(side + r * std::cos(from), 0.0));
        chain.arcTo(centre, r, from, 0.75 * kPi, {0.0, half});
        chain.arcTo(centre, r, 0.75 * kPi, 0.25 * kPi, {2.0 * side, half});
        return chain;
    }
    case SlitEnd::TBone: {
        Chain chain(Vec2(0.0, half));
        chain.arcTo({r, half}, r, kPi, 0.0, {2.0 * r, half});
        return chain;
    }
    }
    return Chain({0.0, half});
}

/// How far along the wall the end reaches.
double wallTaken(SlitEnd end, double r)
{
    return end == SlitEnd::Dogbone ? r * std::numbers::sqrt2
           : end == SlitEnd::TBone ? 2.0 * r
                                   : 0.0;
}

double fittingRadius(const SlitForm &form, double half)
{
    if (form.end == SlitEnd::Square)
        return 0.0;
    return std::min(form.radius, form.end == SlitEnd::Round ? half : kWidest * half);
}

/// A bump on a straight wall between two places of it.
void addBump(Chain &chain, double height, double half, double from, double to)
{
    height = std::min(height, 0.5 * kBumpLengthShare * (to - from) / kBumpHalf);
    if (!(height > kClipSlack))
        return;
    const double reach = kBumpHalf * height, middle = 0.5 * (from + to);
    const double r = (reach * reach + height * height) / (2.0 * height);
    const Vec2 centre(middle, half + r - height);
    const double angle = std::atan2(reach, r - height); // of half of it, seen from the centre
    chain.lineTo({middle - reach, half});
    chain.arcTo(centre, r, 1.5 * kPi - angle, 1.5 * kPi + angle, {middle + reach, half});
}

bool hasLeadIn(const LeadIn &leadIn)
{
    return leadIn.top > 0.0;
}

/// Along the wall from the end to the mouth.
void addMouth(Chain &chain, const LeadIn &leadIn, const SlitBox &box)
{
    if (hasLeadIn(leadIn)) {
        chain.lineTo({leadIn.from, box.half});
        chain.lineTo({leadIn.to.x(), box.half + leadIn.to.y()});
        chain.lineTo({leadIn.top, box.half + leadIn.to.y()});
        chain.lineTo({leadIn.top, box.half});
    }
    chain.lineTo({box.length, box.half});
}

Vec2 mirrored(const Vec2 &p)
{
    return {p.x(), -p.y()};
}

/// The wall to the right, then the one to the left backwards; both given to the left.
Contour closed(const Chain &left, const Chain &right)
{
    Chain chain = right.mapped(mirrored);
    chain.append(left.reversed([](const Vec2 &p) { return p; }));
    chain.lineTo(chain.start);
    return Contour::ofSegments(chain.segments);
}

Contour disc(const Vec2 &centre, double r)
{
    Chain chain(centre + Vec2(r, 0.0));
    chain.arcTo(centre, r, 0.0, 2.0 * kPi, chain.start);
    return Contour::ofSegments(chain.segments);
}

/// The discs of which the arcs are a part, of a slit that is too short for them.
std::vector<Contour> discs(SlitEnd end, double r, const SlitBox &box)
{
    const double side = r * std::numbers::sqrt2 / 2.0;
    const Vec2 centre = end == SlitEnd::Dogbone ? Vec2(side, box.half - side) : Vec2(r, box.half);
    std::vector<Contour> result{disc(centre, r), disc(mirrored(centre), r)};
    if (!box.isOpen) {
        const Vec2 other(box.length - centre.x(), centre.y());
        result.push_back(disc(other, r));
        result.push_back(disc(mirrored(other), r));
    }
    return result;
}

} // namespace

bool hasForm(const Stock &stock)
{
    return stock.slitEnd != SlitEnd::Square || stock.leadIn > 0.0 || stock.bumps > 0.0;
}

SlitForm formOf(const Stock &stock, double width)
{
    SlitForm form;
    form.end = stock.slitEnd;
    if (form.end != SlitEnd::Square)
        form.radius = 0.5 * stock.toolDiameter + kToolAllowance;
    form.bumps = std::min(stock.bumps, kBumpHeightShare * width);
    return form;
}

std::vector<Contour> slitCuts(const SlitForm &form, const SlitBox &box)
{
    const double r = fittingRadius(form, box.half), taken = wallTaken(form.end, r);
    double straight = box.isOpen ? box.length : box.length - taken;
    for (const LeadIn &leadIn : form.leadIns)
        if (hasLeadIn(leadIn))
            straight = std::min(straight, leadIn.from);
    if (straight < taken) {
        SlitForm plain = form;
        plain.end = SlitEnd::Square;
        plain.bumps = 0.0;
        std::vector<Contour> cuts = slitCuts(plain, box);
        std::vector<Contour> more = discs(form.end, r, box);
        std::move(more.begin(), more.end(), std::back_inserter(cuts));
        return cuts;
    }
    Chain wall = endChain(form.end, r, box.half);
    addBump(wall, form.bumps, box.half, taken, std::min(straight, form.held));
    if (!box.isOpen) {
        wall.append(endChain(form.end, r, box.half).reversed([&](const Vec2 &p) {
            return Vec2(box.length - p.x(), p.y());
        }));
        return {closed(wall, wall)};
    }
    Chain left = wall, right = wall;
    addMouth(left, form.leadIns[0], box);
    addMouth(right, form.leadIns[1], box);
    return {closed(left, right)};
}

double looseWall(const SlitForm &form, const SlitBox &box)
{
    double mouth = box.length;
    for (const LeadIn &leadIn : form.leadIns)
        if (hasLeadIn(leadIn))
            mouth = std::min(mouth, leadIn.from);
    return wallTaken(form.end, fittingRadius(form, box.half)) + box.length - mouth;
}

double reachBeyond(const SlitForm &form, double half)
{
    const double r = fittingRadius(form, half);
    if (form.end == SlitEnd::Dogbone)
        return r - r * std::numbers::sqrt2 / 2.0;
    return form.end == SlitEnd::Round ? r : 0.0;
}

} // namespace fff
