// Templates and sections that follow them under every operation, baked, mirrored, copied, scaled,
// saved and undone: a thousand steps at random. If this fails, a guide jumps, a pull is lost, or a
// picture stays behind.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/fff_format.h"
#include "core/model/operation_edits.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/operations/copies.h"
#include "core/operations/excerpt.h"
#include "core/operations/insertion.h"
#include "core/operations/scaled_model.h"
#include "core/session/session.h"
#include "core/templates/flat_template.h"
#include "core/templates/pulled_templates.h"
#include "core/templates/template_curves.h"
#include "core/templates/template_cut.h"
#include "core/templates/template_picture.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/session/dice.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <QUndoStack>

#include <map>

using namespace fff;
using namespace fff::test;

namespace {

constexpr int kSeeds = 8, kSteps = 60, kMostSections = 60, kMostOperations = 4;

Template meshTemplate()
{
    Template one;
    one.name = "Head";
    one.file = "head.stl";
    one.mesh = makeTemplateMesh(mended(head(40, 60)).value().mesh, {}).value();
    return stood(one, *one.mesh, UpAxis::Y, 120.0);
}

Template pictureTemplate(const SectionRef &on)
{
    auto picture = std::make_shared<TemplatePicture>();
    picture->width = picture->height = 4;
    picture->rgba.assign(64, 200);
    Template one;
    one.kind = TemplateKind::Picture;
    one.name = "Picture";
    one.file = "picture.png";
    one.picture = std::move(picture);
    one.scale = 5.0;
    one.on = on;
    return one;
}

Template curvesTemplate()
{
    Template one;
    one.kind = TemplateKind::Curves;
    one.name = "Lines";
    one.file = "lines.svg";
    one.curves =
        makeTemplateCurves({CurvePath::fromLine({{0, 0}, {40, 0}, {40, 30}}).value()}).value();
    one.frame.origin = {0.0, 60.0, 0.0};
    return one;
}

/// What a plane cuts of the mesh, the largest loop whole.
Document withWholeGuide(Document document, const Frame &frame, const Template &mesh)
{
    const std::vector<TemplateLoop> loops = loopsOn(frame, mesh, *mesh.mesh);
    return withSection(std::move(document), Shape::make(curveOf(loops.front()).value(), {}).value(),
                       frame);
}

/// A head, two sections that follow it, into one of which it is pulled, a picture on the other, and
/// a drawing.
Document overTemplates()
{
    Document document = addTemplate(newDocument(), meshTemplate()).value();
    const Template mesh = *document.templates.front();
    const Frame front{{0.0, 60.0, 0.0}, Vec3::UnitX(), Vec3::UnitY()};
    const Frame across{{3.0, 60.0, 0.0}, -Vec3::UnitZ(), Vec3::UnitY()};
    document = withWholeGuide(std::move(document), front, mesh);
    document = withWholeGuide(std::move(document), across, mesh);
    const SectionRef first = document.sections[0]->ref(), second = document.sections[1]->ref();
    document = addTemplate(std::move(document), pictureTemplate(second)).value();
    document = addTemplate(std::move(document), curvesTemplate()).value();
    Template pulled = *document.templates.front();
    pulled.magnets = {{first, 8.0}};
    return setTemplate(std::move(document), pulled).value();
}

/// Where a template is seen to lie, whatever sections it goes with are called.
struct Seen
{
    TemplateMeshPointer mesh;
    std::vector<Vec3> places;    // of a few of its points, pulled where it is
    std::vector<double> opacity; // and how it is shown

    bool isAt(const Seen &other, double factor = 1.0) const
    {
        if (mesh != other.mesh || places.size() != other.places.size() || opacity != other.opacity)
            return false;
        for (std::size_t i = 0; i < places.size(); ++i)
            if ((places[i] - factor * other.places[i]).norm() >
                1e-6 * std::max(1.0, other.places[i].norm()))
                return false;
        return true;
    }
};

std::map<TemplateId, Seen> seenIn(const Model &model)
{
    const PulledTemplates pulled = pullTemplates(model, nullptr).value();
    std::map<TemplateId, Seen> all;
    for (const TemplatePointer &one : model.document.templates) {
        Seen seen{one->mesh, {}, {one->opacity, double(one->isHidden), double(one->isFlipped)}};
        if (one->mesh) {
            const std::vector<Vec3> &positions = pulled.meshOf(*one)->mesh->positions();
            for (std::size_t i = 0; i < positions.size(); i += 97)
                seen.places.push_back(worldPlacement(*one, *one->mesh)(positions[i]));
        } else if (const auto placement = worldPlacement(*one, model)) {
            for (const Vec3 &corner : cornersOf(*one, *placement))
                seen.places.push_back(corner);
        }
        all.emplace(one->id, std::move(seen));
    }
    return all;
}

/// Everything of an evaluated model that a person sees or cuts.
bool isSameModel(const Model &a, const Model &b)
{
    if (!(a.document == b.document) || a.sectionCount() != b.sectionCount())
        return false;
    for (std::size_t i = 0; i < a.sectionCount(); ++i)
        if (!(a.section(i)->frame == b.section(i)->frame) ||
            !(*a.section(i)->shape == *b.section(i)->shape))
            return false;
    return true;
}

} // namespace

class TestTemplateLaws : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomSteps_data();
    void randomSteps();
    void everyOperationOnWholeGuides_data();
    void everyOperationOnWholeGuides();

private:
    void step(Session &session, Dice &dice);
    void addRandomOperation(Session &session, Dice &dice, const OperationKind &kind);
    void bake(Session &session, Dice &dice);
    void copyAndInsert(Session &session, Dice &dice);
    void change(Session &session, Dice &dice);
    void scale(Session &session, Dice &dice);
    void lookAtAll(const Session &session);
    static SectionRef anySection(const Model &model, Dice &dice)
    {
        return model.ref(static_cast<std::size_t>(dice.below(int(model.sectionCount()))));
    }
    static void commit(Session &session, Document document)
    {
        session.commit(QStringLiteral("Step"), std::move(document));
    }

    std::map<std::string, int> m_done; // how often what was tried
    int m_rows = 0;
};

/// What holds of any model: saved and opened it is the same, what is evaluated step by step is what
/// is evaluated at once, and no template has lost what it shows.
void TestTemplateLaws::lookAtAll(const Session &session)
{
    const Model &model = session.committed();
    const auto bytes = io::writeFff(model.document);
    QVERIFY(bytes);
    const auto read = io::readFff(*bytes);
    QVERIFY(read);
    QVERIFY(read->document == model.document);
    QVERIFY(isSameModel(model, evaluate(model.document)));
    for (const TemplatePointer &one : model.document.templates)
        QVERIFY(one->isRead());
}

void TestTemplateLaws::addRandomOperation(Session &session, Dice &dice, const OperationKind &kind)
{
    const Model &model = session.committed();
    const auto before = seenIn(model);
    Operation made = newOperation(kind);
    made.name = kind.key;
    if (kind.isOfTemplate) {
        made.subject = model.document.templates.front()->id;
        made.parameters.insert_or_assign("count", 3.0);
        const auto &choices = kind.parameter("direction")->choices;
        made.parameters.insert_or_assign(
            "direction", std::string(choices[std::size_t(dice.below(int(choices.size())))].key));
        made.parameters.insert_or_assign("hollow", dice.oneIn(2));
    }
    for (const InputSpec &input : kind.inputs)
        made.inputs[input.role].push_back({anySection(model, dice), {}});
    for (const char *count : {"count", "countX", "countY"})
        if (const ParameterSpec *spec = kind.parameter(count))
            made.parameters.insert_or_assign(count, std::max(spec->least, 2.0));
    commit(session, addOperation(model.document, std::move(made)));
    // What operations make and change is beside the templates: but for pictures on a section that
    // one has moved, and magnets there, all stay where they are.
    const auto after = seenIn(session.committed());
    for (const auto &[id, seen] : before) {
        const Template &one = *session.committed().document.find(id);
        if (one.magnets.empty() && one.on == SectionRef())
            QVERIFY(after.at(id).isAt(seen));
    }
    ++m_done[kind.key];
}

void TestTemplateLaws::bake(Session &session, Dice &dice)
{
    const Model &model = session.committed();
    if (model.document.operations.empty())
        return;
    const auto before = seenIn(model);
    const Operation &operation =
        *model.document.operations[std::size_t(dice.below(int(model.document.operations.size())))];
    const SectionRef instance = anySection(model, dice);
    const bool isOne = dice.oneIn(2) && instance.operation.isValid();
    const auto next = isOne ? detached(model, instance) : baked(model, operation.id);
    if (!next)
        return; // of operations that change what is there there is nothing to detach
    commit(session, *next);
    const auto after = seenIn(session.committed());
    QCOMPARE(after.size(), before.size());
    for (const auto &[id, seen] : before)
        QVERIFY2(after.at(id).isAt(seen), operation.kind.c_str());
    ++m_done[isOne ? "detached" : "baked"];
}

void TestTemplateLaws::copyAndInsert(Session &session, Dice &dice)
{
    const Model &model = session.committed();
    const auto before = seenIn(model);
    const std::vector<SectionRef> some{anySection(model, dice)};
    if (dice.oneIn(2)) {
        const Copies copies = copied(model, some, 1 + dice.below(2));
        const auto placed = placedCopies(
            copies, [](int k) { return Similarity::moved(Vec3(7.0 * k, 0.0, 3.0 * k)); });
        commit(session, placed ? *placed : copies.document);
        ++m_done["copied"];
    } else {
        // From another window: a document of these sections alone, which can be saved.
        const Document part = excerpt(model, some);
        QVERIFY(io::readFff(io::writeFff(part).value()));
        commit(session, inserted(model.document, part).document);
        ++m_done["inserted"];
    }
    const auto after = seenIn(session.committed());
    for (const auto &[id, seen] : before)
        QVERIFY(after.at(id).isAt(seen));
}

void TestTemplateLaws::change(Session &session, Dice &dice)
{
    const Document &document = session.committed().document;
    if (document.templates.empty())
        return;
    const std::size_t which = std::size_t(dice.below(int(document.templates.size())));
    Template one = *document.templates[which];
    switch (dice.below(6)) {
    case 0:
        one.frame.origin += Vec3(dice.between(-9, 9), dice.between(-9, 9), 0.0);
        break;
    case 1:
        one.opacity = dice.between(0.0, 1.0);
        break;
    case 2:
        one.isFlipped = !one.isFlipped;
        break;
    case 3:
        if (one.mesh)
            one.magnets.push_back({anySection(session.committed(), dice), 5.0});
        break;
    case 4:
        if (one.mesh)
            one.magnets.clear();
        break;
    default:
        if (one.mesh && document.templates.size() < 5) { // the same once more, smaller
            one.scale *= 0.5;
            commit(session, addTemplate(document, one).value());
        } else if (document.templates.size() > 3) {
            commit(session, removeTemplate(document, document.templates.back()->id).value());
        }
        return;
    }
    commit(session, setTemplate(document, one).value());
    ++m_done["changed"];
}

void TestTemplateLaws::scale(Session &session, Dice &dice)
{
    const Model &model = session.committed();
    const auto before = seenIn(model);
    const double factor = dice.oneIn(2) ? 0.5 : 2.0;
    const auto scaled = scaledModel(model.document, factor);
    if (!scaled)
        return; // a number of an operation would leave its range
    commit(session, *scaled);
    const auto after = seenIn(session.committed());
    for (const auto &[id, seen] : before) {
        const Template &one = *session.committed().document.find(id);
        if (one.magnets.empty() && one.on == SectionRef())
            QVERIFY(after.at(id).isAt(seen, factor));
    }
    commit(session, scaledModel(*scaled, 1.0 / factor).value());
    ++m_done["scaled"];
}

void TestTemplateLaws::step(Session &session, Dice &dice)
{
    const auto kinds = operationKinds();
    const Model &model = session.committed();
    if (model.sectionCount() == 0 || int(model.sectionCount()) > kMostSections ||
        int(model.document.operations.size()) > kMostOperations) {
        while (session.history()->canUndo() && dice.below(4) > 0)
            session.history()->undo();
        return;
    }
    switch (dice.below(8)) {
    case 0:
    case 1:
    case 2:
        return addRandomOperation(session, dice,
                                  *kinds[std::size_t(dice.below(int(kinds.size())))]);
    case 3:
        return bake(session, dice);
    case 4:
        return copyAndInsert(session, dice);
    case 5:
        return scale(session, dice);
    default:
        return change(session, dice);
    }
}

void TestTemplateLaws::randomSteps_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= kSeeds; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void TestTemplateLaws::randomSteps()
{
    QFETCH(const int, seed);
    Dice dice(std::uint64_t(seed) * 77);
    Session session;
    const Document beginning = overTemplates();
    session.reset(beginning);
    for (int i = 0; i < kSteps; ++i) {
        step(session, dice);
        if (QTest::currentTestFailed())
            return;
        lookAtAll(session);
        if (QTest::currentTestFailed())
            return;
    }
    QUndoStack &history = *session.history();
    const Document end = session.committed().document;
    const int steps = history.index();
    while (history.canUndo())
        history.undo();
    QVERIFY(session.committed().document == beginning);
    for (std::size_t i = 0; i < beginning.templates.size(); ++i)
        QCOMPARE(session.committed().document.templates[i], beginning.templates[i]);
    while (history.index() < steps)
        history.redo();
    QVERIFY(session.committed().document == end);
    if (++m_rows == kSeeds) // all of it was really done, over all seeds
        for (const char *what :
             {"linear", "revolve", "blend", "branch", "grid", "radial", "mirror", "rotational",
              "array", "slices", "baked", "detached", "copied", "inserted", "changed", "scaled"})
            QVERIFY2(m_done[what] > 0, what);
}

void TestTemplateLaws::everyOperationOnWholeGuides_data()
{
    QTest::addColumn<QString>("kind");
    for (const OperationKind *kind : operationKinds())
        QTest::newRow(kind->key) << QString::fromLatin1(kind->key);
}

/// Sections that lie on the mesh still do so to 0.05 mm while an operation works on them, after it
/// was baked and after that was undone; so do their copies in place.
void TestTemplateLaws::everyOperationOnWholeGuides()
{
    QFETCH(const QString, kind);
    Dice dice(5);
    Session session;
    session.reset(overTemplates());
    Template unpulled = *session.committed().document.templates.front();
    unpulled.magnets.clear();
    commit(session, setTemplate(session.committed().document, unpulled).value());
    const auto liesOnMesh = [&](const Section &section) {
        const Template &mesh = *session.committed().document.templates.front();
        const std::vector<TemplateLoop> loops = loopsOn(section.frame, mesh, *mesh.mesh);
        for (const Vec2 &p : section.shape->contour().polygon(0.005)) {
            double nearest = 1e9;
            for (const TemplateLoop &loop : loops)
                for (std::size_t i = 0; i < loop.points.size(); ++i) {
                    const Vec2 &a = loop.points[i], &b = loop.points[(i + 1) % loop.points.size()];
                    const double t =
                        std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                    nearest = std::min(nearest, (a + t * (b - a) - p).norm());
                }
            if (nearest > 0.05)
                return false;
        }
        return true;
    };
    const std::vector<SectionId> drawn{session.committed().document.sections[0]->id,
                                       session.committed().document.sections[1]->id};
    const auto bothDo = [&] {
        for (const SectionId id : drawn)
            if (!liesOnMesh(*session.committed().document.find(id)))
                return false;
        return true;
    };
    QVERIFY(bothDo());
    addRandomOperation(session, dice, *operationKind(kind.toStdString()));
    QVERIFY(bothDo());
    const Copies copies = copied(session.committed(), {SectionRef(drawn[0])});
    const Model after = evaluate(copies.document);
    const Section &copy = *after.find(SectionRef(copies.drawn.front().front()));
    const Section &shown = *session.committed().find(SectionRef(drawn[0]));
    QVERIFY(copy.frame == shown.frame && *copy.shape == *shown.shape);
    // Some operations change what they are given; all others leave it on the mesh.
    if (*shown.shape == *session.committed().document.find(drawn[0])->shape)
        QVERIFY(liesOnMesh(copy));
    const Document before = session.committed().document;
    if (const auto next = baked(session.committed(), before.operations.front()->id)) {
        commit(session, *next);
        session.history()->undo();
        QVERIFY(session.committed().document == before);
    }
    session.history()->undo();
    QVERIFY(bothDo());
    QVERIFY(session.committed().document.operations.empty());
}

FFF_TEST(TestTemplateLaws)
#include "tst_template_laws.moc"
