// Makes the samples of resources/samples that are built from numbers rather than drawn:
//     make_samples FOLDER
// Run by hand when a sample is to change; its output is committed. tests/ui/start/tst_samples looks
// at what is there.
#include "core/base/units.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace fff;

namespace {

/// A document that grows section by section; the program ends at the first mistake.
class Maker
{
public:
    explicit Maker(double thickness)
    {
        Stock stock = *m_document.stocks.front();
        stock.thickness = thickness;
        take(setStock(m_document, stock));
    }

    void add(const std::string &name, const Frame &frame, Contour contour,
             std::vector<Contour> holes = {})
    {
        NewSection section;
        section.name = name;
        section.frame = frame;
        const auto shape = Shape::make(std::move(contour), std::move(holes));
        if (!shape)
            fail(name);
        section.shape = *shape;
        take(addSection(m_document, section));
    }

    void write(const std::string &folder, const std::string &name) const
    {
        if (!io::writeDocument(QString::fromStdString(folder + "/" + name + ".fff"), m_document))
            fail(name);
    }

private:
    [[noreturn]] static void fail(const std::string &what)
    {
        std::fprintf(stderr, "%s could not be made\n", what.c_str());
        std::exit(1);
    }
    void take(Result<Document> next)
    {
        if (!next)
            fail("the document");
        m_document = std::move(*next);
    }

    Document m_document = newDocument();
};

// Planes. In the upright ones, local coordinates are across and up.
Frame facingFront(double z)
{
    return {{0.0, 0.0, z}, Vec3::UnitX(), Vec3::UnitY()};
}
Frame facingRight(double x) // across runs to the back
{
    return {{x, 0.0, 0.0}, -Vec3::UnitZ(), Vec3::UnitY()};
}
Frame lying(double y) // across runs to the right, up to the back
{
    return {{0.0, y, 0.0}, Vec3::UnitX(), -Vec3::UnitZ()};
}
Frame radial(double angle) // across runs outwards from the middle
{
    return {Vec3::Zero(), {std::cos(angle), 0.0, std::sin(angle)}, Vec3::UnitY()};
}

struct Corner
{
    Vec2 at;
    bool isSharp = false;
};

/// Through these points; smooth but at the sharp ones (a chord a third of the way to the
/// neighbours, after Catmull and Rom).
Contour through(const std::vector<Corner> &corners)
{
    const std::size_t n = corners.size();
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < n; ++i) {
        const Corner &before = corners[(i + n - 1) % n], &a = corners[i], &b = corners[(i + 1) % n],
                     &after = corners[(i + 2) % n];
        const Vec2 atA = a.isSharp ? Vec2(b.at - a.at) : Vec2((b.at - before.at) / 2.0);
        const Vec2 atB = b.isSharp ? Vec2(b.at - a.at) : Vec2((after.at - a.at) / 2.0);
        points.push_back(a.at);
        points.push_back(a.at + atA / 3.0);
        points.push_back(b.at - atB / 3.0);
    }
    return *Contour::fromPoints(points);
}

Contour ellipse(const Vec2 &middle, double rx, double ry)
{
    constexpr double k = 0.5522847498; // quarter of a circle by one cubic
    const auto at = [&](double x, double y) { return Vec2(middle + Vec2(rx * x, ry * y)); };
    return *Contour::fromPoints({at(1, 0), at(1, k), at(k, 1), at(0, 1), at(-k, 1), at(-1, k),
                                 at(-1, 0), at(-1, -k), at(-k, -1), at(0, -1), at(k, -1),
                                 at(1, -k)});
}

Contour roundedRectangle(const Vec2 &middle, double width, double height, double radius)
{
    constexpr double k = 0.5522847498;
    const double a = width / 2.0 - radius, b = height / 2.0 - radius;
    std::vector<Vec2> points;
    const Vec2 corners[] = {{a, -b}, {a, b}, {-a, b}, {-a, -b}};
    Vec2 out(0.0, -radius); // from the corner's middle to where its arc begins
    for (int i = 0; i < 4; ++i) {
        const Vec2 along(-out.y(), out.x()), from = middle + corners[i] + out,
                                             to = middle + corners[i] + along,
                                             next = middle + corners[(i + 1) % 4] + along;
        points.insert(points.end(), {from, from + k * along, to + k * out, to,
                                     to + (next - to) / 3.0, next + (to - next) / 3.0});
        out = along;
    }
    return *Contour::fromPoints(points);
}

/// A trout on two feet: one body, ribs across it.
void fish(const std::string &folder)
{
    Maker maker(3.0);
    maker.add(
        "Body", facingFront(0.0),
        through({{{-128, 66}},     {{-112, 84}},      {{-84, 98}}, {{-46, 108}}, {{-34, 128}, true},
                 {{-4, 126}},      {{22, 106}},       {{58, 92}},  {{92, 80}},   {{136, 112}, true},
                 {{128, 76}},      {{136, 40}, true}, {{92, 66}},  {{62, 50}},   {{36, 42}},
                 {{20, 26}, true}, {{4, 38}},         {{-40, 36}}, {{-84, 42}},  {{-114, 54}}}),
        {ellipse({-102, 76}, 5, 5)});
    // Where, how wide to each side, from and to which height.
    const double ribs[][4] = {{-86, 22, 50, 91}, {-66, 29, 44, 97}, {-20, 33, 44, 98},
                              {4, 31, 47, 95},   {50, 18, 57, 86},  {70, 12, 62, 80}};
    int number = 1;
    for (const auto &[x, wide, low, high] : ribs)
        maker.add("Rib " + std::to_string(number++), facingRight(x),
                  ellipse({0, (low + high) / 2}, wide, (high - low) / 2));
    for (const double x : {-43.0, 27.0}) {
        const bool isFront = x < 0;
        const double wide = isFront ? 33 : 26, middle = isFront ? 72 : 70, up = isFront ? 28 : 22;
        maker.add(isFront ? "Front foot" : "Hind foot", facingRight(x),
                  through({{{0, middle + up}},
                           {{-wide * 0.8, middle + up * 0.6}},
                           {{-wide, middle}},
                           {{-wide * 0.62, middle - up * 0.85}},
                           {{-16, 24}},
                           {{-38, 7}},
                           {{-40, 0}, true},
                           {{-18, 0}, true},
                           {{0, 11}},
                           {{18, 0}, true},
                           {{40, 0}, true},
                           {{38, 7}},
                           {{16, 24}},
                           {{wide * 0.62, middle - up * 0.85}},
                           {{wide, middle}},
                           {{wide * 0.8, middle + up * 0.6}}}));
    }
    maker.write(folder, "fish");
}

/// Carries four glasses at a handle.
void glassHolder(const std::string &folder)
{
    Maker maker(4.0);
    constexpr double high = 150, shelf = 70, floor = 22;
    for (const double x : {-82.0, 82.0})
        maker.add(x < 0 ? "Left side" : "Right side", facingRight(x),
                  through({{{-72, 0}, true},
                           {{-44, 0}, true},
                           {{-30, 11}},
                           {{0, 14}},
                           {{30, 11}},
                           {{44, 0}, true},
                           {{72, 0}, true},
                           {{70, 44}},
                           {{56, 84}},
                           {{30, 112}},
                           {{25, high}},
                           {{0, high + 12}},
                           {{-25, high}},
                           {{-30, 112}},
                           {{-56, 84}},
                           {{-70, 44}}}));
    std::vector<Contour> holes;
    for (const double x : {-37.0, 37.0}) {
        for (const double z : {-36.0, 36.0})
            holes.push_back(ellipse({x, z}, 31, 31));
    }
    maker.add("Shelf", lying(shelf), roundedRectangle({0, 0}, 208, 168, 12), holes);
    maker.add("Floor", lying(floor), roundedRectangle({0, 0}, 208, 168, 12));
    maker.add("Handle", facingFront(0.0),
              through({{{-106, high - 14}},
                       {{-96, high - 24}},
                       {{0, high - 20}},
                       {{96, high - 24}},
                       {{106, high - 14}},
                       {{96, high + 2}},
                       {{0, high + 8}},
                       {{-96, high + 2}}}));
    maker.write(folder, "glass_holder");
}

/// A fir of two silhouettes with small ones across.
void tree(const std::string &folder)
{
    Maker maker(3.0);
    const auto silhouette = [](double wide) {
        const std::vector<Vec2> right = {{27, 0},
                                         {9, 14},
                                         {wide, 34},
                                         {wide * 0.5, 70},
                                         {wide * 0.76, 72},
                                         {wide * 0.36, 108},
                                         {wide * 0.54, 110},
                                         {wide * 0.2, 144},
                                         {wide * 0.32, 146}};
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < right.size(); ++i)
            corners.push_back({right[i], i < 2 || i % 2 == 0});
        corners.push_back({{0, 184}, true});
        for (std::size_t i = right.size(); i-- > 0;)
            corners.push_back({{-right[i].x(), right[i].y()}, i < 2 || i % 2 == 0});
        return through(corners);
    };
    maker.add("Fir", facingFront(0.0), silhouette(72));
    maker.add("Fir across", facingRight(0.0), silhouette(72));
    const auto twig = [](double low, double high, double wide) {
        return through({{{0, high}, true},
                        {{-wide * 0.45, low + (high - low) * 0.42}},
                        {{-wide, low}, true},
                        {{0, low + 5}},
                        {{wide, low}, true},
                        {{wide * 0.45, low + (high - low) * 0.42}}});
    };
    int number = 1;
    for (const double at : {-40.0, 40.0}) {
        maker.add("Twig " + std::to_string(number++), facingRight(at), twig(38, 92, 30));
        maker.add("Twig " + std::to_string(number++), facingFront(at), twig(38, 92, 30));
    }
    for (const double at : {-22.0, 22.0}) {
        maker.add("Twig " + std::to_string(number++), facingRight(at), twig(78, 140, 18));
        maker.add("Twig " + std::to_string(number++), facingFront(at), twig(78, 140, 18));
    }
    maker.write(folder, "tree");
}

/// A chair for a doll.
void chair(const std::string &folder)
{
    Maker maker(3.0);
    const auto side = [] {
        // The back is at positive coordinates.
        return through({{{-58, 0}, true},
                        {{-42, 0}, true},
                        {{-38, 40}},
                        {{-22, 60}},
                        {{20, 60}},
                        {{36, 40}},
                        {{46, 0}, true},
                        {{62, 0}, true},
                        {{54, 50}},
                        {{56, 110}},
                        {{68, 190}},
                        {{58, 196}},
                        {{48, 188}},
                        {{38, 120}},
                        {{26, 94}},
                        {{-20, 88}},
                        {{-52, 90}},
                        {{-58, 80}}});
    };
    for (const double x : {-48.0, 48.0})
        maker.add(x < 0 ? "Left side" : "Right side", facingRight(x), side());
    maker.add("Seat", lying(76.0),
              through({{{-64, -72}},
                       {{0, -78}},
                       {{64, -72}},
                       {{66, -20}},
                       {{60, 22}},
                       {{56, 30}, true},
                       {{-56, 30}, true},
                       {{-60, 22}},
                       {{-66, -20}}}));
    const auto slat = [](double middle, double rise) {
        return through({{{-66, middle - 8}, false},
                        {{0, middle - 10 + rise}},
                        {{66, middle - 8}},
                        {{68, middle}},
                        {{64, middle + 9}},
                        {{0, middle + 10 + rise}},
                        {{-64, middle + 9}},
                        {{-68, middle}}});
    };
    maker.add("Upper slat", facingFront(-56.0), slat(166, 5));
    maker.add("Lower slat", facingFront(-48.0), slat(130, 4));
    maker.add("Front rail", facingFront(44.0), slat(30, 6));
    maker.write(folder, "chair");
}

/// An organiser for a desk: compartments of upright plates that cross.
void organiser(const std::string &folder)
{
    Maker maker(3.0);
    constexpr double high = 70, wide = 105, deep = 66;
    const auto wall = [](double half, double height, double dip) {
        return through({{{-half, 0}, true},
                        {{half, 0}, true},
                        {{half, height}, true},
                        {{half * 0.5, height}, false},
                        {{0, height - dip}},
                        {{-half * 0.5, height}, false},
                        {{-half, height}, true}});
    };
    maker.add("Back", facingFront(-deep + 12), wall(wide, high + 20, -10));
    maker.add("Middle", facingFront(0.0), wall(wide, high, 0));
    maker.add("Front", facingFront(deep - 12), wall(wide, high - 20, 10));
    int number = 1;
    for (const double x : {-93.0, -31.0, 31.0, 93.0}) {
        const bool isOuter = std::abs(x) > 60;
        // To the back at positive coordinates: it rises there.
        const Contour slope = through({{{-deep, 0}, true},
                                       {{deep, 0}, true},
                                       {{deep, high + 20}, true},
                                       {{deep - 24, high + 20}},
                                       {{0, high}},
                                       {{-deep + 24, high - 20}},
                                       {{-deep, high - 20}, true}});
        std::vector<Contour> holes;
        if (isOuter)
            holes.push_back(roundedRectangle({28, high - 16}, 34, 15, 7));
        maker.add("Wall " + std::to_string(number++), facingRight(x), slope, holes);
    }
    maker.write(folder, "organiser");
}

/// A shade of fins that two rings hold.
void lamp(const std::string &folder)
{
    Maker maker(2.0);
    constexpr int fins = 12;
    for (int i = 0; i < fins; ++i) {
        maker.add("Fin " + std::to_string(i + 1), radial(radians(360.0 * i / fins)),
                  through({{{42, 0}, true},
                           {{66, 0}, true},
                           {{78, 40}},
                           {{84, 84}},
                           {{72, 132}},
                           {{50, 168}},
                           {{34, 176}, true},
                           {{30, 160}},
                           {{40, 124}},
                           {{48, 84}},
                           {{46, 40}}}));
    }
    maker.add("Lower ring", lying(34.0), ellipse({0, 0}, 62, 62), {ellipse({0, 0}, 36, 36)});
    maker.add("Upper ring", lying(150.0), ellipse({0, 0}, 47, 47), {ellipse({0, 0}, 20, 20)});
    maker.write(folder, "lamp");
}

} // namespace

int main(int argc, char *argv[])
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_samples FOLDER\n");
        return 1;
    }
    for (auto make : {fish, glassHolder, tree, chair, organiser, lamp})
        make(argv[1]);
    return 0;
}
