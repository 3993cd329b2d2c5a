#include "tests/core/session/law_models.h"

#include "core/io/document_file.h"
#include "core/model/load_edits.h"
#include "core/operations/baking.h"
#include "core/operations/evaluate.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/random_drawings.h"

#include <QDir>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace fff::test {

namespace {

constexpr double kLightLoad = 0.05; // kg: breaks nothing, and is more than plates weigh
constexpr int kEveryNth = 3;        // section bears one
constexpr double kShown = 0.2;      // of what a sheet bears: below, nothing is coloured

const QString kDrawing = QStringLiteral("drawing "), kCrate = QStringLiteral("crate ");

Document readFrom(const char *folder, const QString &name)
{
    const auto loaded = io::readDocument(QDir(QString::fromLatin1(folder)).filePath(name));
    return loaded ? loaded->document : Document();
}

Document withoutOperations(Document document)
{
    while (!document.operations.empty()) {
        const Model model = evaluate(document);
        const OperationId first = document.operations.front()->id;
        Result<Document> next = baked(model, first);
        if (!next)
            return Document();
        document = *std::move(next);
    }
    return document;
}

/// Weights of different mass on some sections, in their middle.
Document withSomethingOnIt(Document document)
{
    if (!document.loads.empty())
        return document;
    for (std::size_t i = 0; i < document.sections.size(); i += kEveryNth) {
        const Section &section = *document.sections[i];
        Load weight;
        weight.section = section.id;
        weight.position = section.shape->centroid();
        weight.mass = kLightLoad * (1.0 + static_cast<double>(i % 5));
        if (Result<Document> next = addLoad(document, weight))
            document = *std::move(next);
    }
    return document;
}

Document onTheGround(Document document)
{
    double least = std::numeric_limits<double>::infinity();
    for (const SectionPointer &section : document.sections)
        for (const Vec2 &p : section->shape->region().outer)
            least = std::min(least, section->frame.toWorld(p).y());
    for (SectionPointer &pointer : document.sections) {
        Section section = *pointer;
        section.frame.origin.y() -= least;
        pointer = std::make_shared<const Section>(std::move(section));
    }
    return document;
}

/// Strips across each other with weights at any place: several feet, joints in rings.
Document crate(unsigned seed)
{
    std::mt19937 random(seed);
    Document document =
        eggCrate(2 + static_cast<int>(random() % 3), 2 + static_cast<int>(random() % 3));
    const std::size_t count = document.sections.size();
    for (int i = 0; i < 3; ++i) {
        Load weight;
        weight.section = document.sections[random() % count]->id;
        weight.position = {5.0 + static_cast<double>(random() % 50), 35.0};
        weight.mass = kLightLoad * static_cast<double>(1 + random() % 20);
        document = *addLoad(std::move(document), weight);
    }
    return document;
}

bool isNear(double a, double b, double share, double floor)
{
    return std::abs(a - b) <= share * std::max({std::abs(a), std::abs(b), floor});
}

QString sentence(std::int64_t section, double here, const QString &at, double there,
                 const QString &by)
{
    return QStringLiteral("section %1: %2 at %3; %4 at %5")
        .arg(section)
        .arg(here, 0, 'g', 10)
        .arg(at)
        .arg(there, 0, 'g', 10)
        .arg(by);
}

/// From where a verdict changes no use is nearer than that.
bool isClear(const StrengthAnswer &answer, double share)
{
    const double safety = StrengthRules().safety;
    return !isNear(safety * answer.neckUse, 1.0, 2.0 * share, 1.0) &&
           !isNear(safety * answer.cornerUse, 1.0, 2.0 * share, 1.0);
}

} // namespace

QString told(const std::optional<NeckStress> &neck)
{
    if (!neck)
        return QStringLiteral("nowhere");
    QString text = QStringLiteral("kind %1 from %2 %3 to %4 %5, l %6")
                       .arg(static_cast<int>(neck->kind))
                       .arg(neck->begin.x())
                       .arg(neck->begin.y())
                       .arg(neck->end.x())
                       .arg(neck->end.y())
                       .arg(neck->length);
    const std::pair<bool, const char *> words[] = {
        {neck->isShadowed, " shadowed"},           {neck->doubts.isStubby, " stubby"},
        {neck->doubts.isNearForce, " by a force"}, {neck->doubts.isNearCorner, " by a corner"},
        {neck->doubts.isCurved, " curved"},        {neck->doubts.isRedundant, " redundant"}};
    for (const auto &[is, word] : words)
        if (is)
            text += QLatin1String(word);
    return text;
}

Document lawModel(const QString &name)
{
    Document document;
    if (name.startsWith(kDrawing))
        document = onTheGround(randomDrawing(name.mid(kDrawing.size()).toULongLong()));
    else if (name.startsWith(kCrate))
        document = crate(name.mid(kCrate.size()).toUInt());
    else
        document = withoutOperations(readFrom(
            name.endsWith(QStringLiteral(".fff")) ? FFF_SAMPLES : FFF_SHARED_MODELS, name));
    return withSomethingOnIt(std::move(document));
}

std::vector<QString> lawModels(int drawings, int crates)
{
    std::vector<QString> names;
    for (const char *folder : {FFF_SAMPLES, FFF_SHARED_MODELS}) {
        const QStringList kinds{QStringLiteral("*.fff"), QStringLiteral("*.txt")};
        for (const QString &name :
             QDir(QString::fromLatin1(folder)).entryList(kinds, QDir::Files, QDir::Name))
            names.push_back(name);
    }
    for (int i = 1; i <= drawings; ++i)
        names.push_back(kDrawing + QString::number(i));
    for (int i = 1; i <= crates; ++i)
        names.push_back(kCrate + QString::number(i));
    return names;
}

StrengthAnswer answerOf(const Analysis &analysis, const Strength &strength)
{
    StrengthAnswer answer;
    const Equilibrium &equilibrium = strength.equilibrium();
    answer.verdict = strength.verdict;
    answer.balance = equilibrium.balance();
    answer.indeterminacy = equilibrium.indeterminacy();
    answer.neckUse = strength.neckUse;
    answer.cornerUse = strength.cornerUse;
    for (std::size_t i = 0; i < strength.bodies.size(); ++i) {
        const auto section =
            static_cast<std::size_t>(analysis.bodies.sectionOf(static_cast<int>(i)));
        SectionUse &use = answer.uses[analysis.model.ref(section).drawn.value];
        const BodyStrength &body = strength.bodies[i];
        if (body.neckUse > use.neck) {
            use.neck = body.neckUse;
            use.neckTold = told(body.neck);
        }
        if (body.cornerUse > use.corner) {
            use.corner = body.cornerUse;
            use.cornerTold = told(body.corner);
        }
    }
    const Structure &structure = strength.made.structure;
    for (std::size_t i = 0; i < structure.feet.size(); ++i)
        answer.feet.emplace_back(structure.feet[i].point, equilibrium.feet[i].force);
    for (const Member &member : structure.members)
        answer.weight -= member.mass * structure.gravity.dot(structure.up);
    for (const MemberLoad &load : structure.loads)
        answer.weight -= load.force.dot(structure.up);
    return answer;
}

StrengthAnswer answerOf(const Document &document, const StrengthRules &rules)
{
    const Analysis analysis = analysed(document);
    StrengthCaches caches;
    return answerOf(analysis, strengthOf(analysis, rules, caches));
}

QString differenceOf(const StrengthAnswer &first, const StrengthAnswer &second,
                     const LawBound &bound, const MapOfVectors &place, const MapOfVectors &force)
{
    if (first.balance != second.balance)
        return QStringLiteral("it stands otherwise");
    const double near = bound.share * std::max(1.0, bound.least);
    if (first.verdict != second.verdict && isClear(first, near) && isClear(second, near))
        return QStringLiteral("another verdict");
    if (bound.isSame && first.indeterminacy != second.indeterminacy)
        return QStringLiteral("indeterminate by %1 and %2")
            .arg(first.indeterminacy)
            .arg(second.indeterminacy);
    for (const auto &[section, use] : first.uses) {
        const auto other = second.uses.find(section);
        if (other == second.uses.end())
            return QStringLiteral("no section %1").arg(section);
        if (!isNear(use.neck, other->second.neck, bound.share, bound.least))
            return sentence(section, use.neck, use.neckTold, other->second.neck,
                            other->second.neckTold);
        if (!isNear(use.corner, other->second.corner, bound.share, bound.least))
            return sentence(section, use.corner, use.cornerTold, other->second.corner,
                            other->second.cornerTold);
    }
    if (first.balance != Balance::Stands)
        return {}; // what falls is carried by nothing
    if (bound.isSame && first.feet.size() != second.feet.size())
        return QStringLiteral("other feet");
    for (const auto &[point, carried] : first.feet) {
        const Vec3 at = place ? place(point) : point, wanted = force ? force(carried) : carried;
        bool isThere = false;
        for (const auto &[other, found] : second.feet)
            isThere = isThere || ((other - at).norm() < bound.feet &&
                                  (found - wanted).norm() <= bound.share * second.weight);
        if (!isThere)
            return QStringLiteral("the foot at %1 %2 with %3 N of %4 carries something else")
                .arg(point.x())
                .arg(point.z())
                .arg(carried.y(), 0, 'g', 10)
                .arg(first.weight);
    }
    return {};
}

} // namespace fff::test
