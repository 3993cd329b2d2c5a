#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/point_sight.h"
#include "core/model/edits.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

const Vec2 kView(800.0, 600.0);

/// A disc of many points, which is smooth all round, with a square corner cut into it if asked for.
Section disc(int points, bool hasCorner = false)
{
    std::vector<Vec2> ring;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        ring.push_back(50.0 * Vec2(std::cos(angle), std::sin(angle)));
    }
    if (hasCorner)
        ring[static_cast<std::size_t>(points / 3)] *= 0.5;
    const Document document = withSection(newDocument(), polygonShape(ring), front());
    return *document.sections.front();
}

Camera scaled(double perPixel)
{
    Camera camera;
    camera.target = Vec3::Zero();
    camera.millimetresPerPixel = perPixel;
    return camera;
}

Vec2 placeOf(const Section &section, const PointAddress &point, const Camera &camera)
{
    const Contour &contour = boundary(*section.shape, point.boundary);
    return camera.toScreen(section.frame.toWorld(contour.segment(point.index).p0), kView);
}

} // namespace

class TestThinnedPoints : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A caterpillar of squares hides the contour, and none can be told from the next.
    void noneClump_data()
    {
        QTest::addColumn<double>("perPixel");
        for (const double scale : {0.02, 0.1, 0.4, 1.0, 3.0})
            QTest::addRow("%.2f mm a pixel", scale) << scale;
    }

    void noneClump()
    {
        QFETCH(double, perPixel);
        const Section section = disc(160);
        const Camera camera = scaled(perPixel);
        const std::vector<PointAddress> shown = shownPoints(section, {}, camera, kView);
        QVERIFY(!shown.empty());
        const auto distance = [&](const PointAddress &a, const PointAddress &b) {
            return (placeOf(section, a, camera) - placeOf(section, b, camera)).norm();
        };
        for (std::size_t i = 0; i < shown.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY(distance(shown[i], shown[k]) >= 12.0 - 1e-9);
        // Nor is one left out for nothing.
        for (int i = 0; i < 160; ++i)
            QVERIFY(std::any_of(shown.begin(), shown.end(), [&](const PointAddress &other) {
                return distance({0, i}, other) < 12.0;
            }));
        if (perPixel < 0.15) // the points are 2 mm apart: all are there
            QCOMPARE(shown.size(), std::size_t(160));
    }

    /// What is in the hand must not go when one zooms out.
    void whatIsSelectedStays()
    {
        const Section section = disc(160);
        const std::vector<PointAddress> selected{{0, 3}, {0, 4}, {0, 5}};
        const std::vector<PointAddress> shown = shownPoints(section, selected, scaled(2.0), kView);
        QVERIFY(std::includes(shown.begin(), shown.end(), selected.begin(), selected.end()));
        QVERIFY(std::is_sorted(shown.begin(), shown.end()));
    }

    /// Panning must not make points come and go.
    void whereTheViewIsDoesNotMatter()
    {
        const Section section = disc(160, true);
        Camera camera = scaled(0.7);
        const std::vector<PointAddress> before = shownPoints(section, {}, camera, kView);
        camera.target += Vec3(31.3, -12.9, 0.0);
        QVERIFY(shownPoints(section, {}, camera, kView) == before);
    }

    /// What is not shown cannot be dragged by chance.
    void whatIsNotShownIsNotHit()
    {
        const Document document = withSection(newDocument(), disc(160).shape, front());
        const Model model = evaluate(document);
        const Camera camera = scaled(2.0);
        const ViewState view;
        const Sight sight{model, camera, kView, view, {}};
        const Section &section = *document.sections.front();
        const std::vector<PointAddress> shown = shownPoints(section, {}, camera, kView);
        QVERIFY(shown.size() < 60);
        for (int i = 0; i < 160; ++i) {
            const auto hit =
                pointTargetAt(sight, model.ref(0), {}, placeOf(section, {0, i}, camera));
            QVERIFY(!hit || hit->kind != PointTarget::Kind::Anchor ||
                    std::find(shown.begin(), shown.end(), hit->point) != shown.end());
        }
    }
};

FFF_TEST(TestThinnedPoints)
#include "tst_thinned_points.moc"
