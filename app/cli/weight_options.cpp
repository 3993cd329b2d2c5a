#include "app/cli/weight_options.h"

#include "core/base/expression.h"

#include <QRegularExpression>

#include <limits>

namespace fff::cli {

namespace {

/// Kilograms or grams: of a number alone nobody knows, so that it is none.
constexpr double kNoUnit = std::numeric_limits<double>::quiet_NaN();

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// As a field of the window reads it. Commas are not for a line that is to mean the same wherever
/// it is typed.
std::optional<double> massOf(const QString &text)
{
    if (text.contains(u','))
        return std::nullopt;
    const auto mass = readMass(text.toStdString(), kNoUnit, Commas::Decimals).value;
    return mass && *mass > 0.0 && *mass <= kMaxWeight ? mass : std::nullopt;
}

/// "NAME@X,Y" where the section is not called so itself.
std::optional<Vec2> placeIn(QString &name)
{
    static const QRegularExpression form(QStringLiteral("^(.*)@([-+.0-9eE]+),([-+.0-9eE]+)$"));
    const QRegularExpressionMatch match = form.match(name);
    if (!match.hasMatch())
        return std::nullopt;
    bool isX = false, isY = false;
    const Vec2 place(match.captured(2).toDouble(&isX), match.captured(3).toDouble(&isY));
    if (!isX || !isY || !place.allFinite() || place.cwiseAbs().maxCoeff() > kMaxCoordinate)
        return std::nullopt;
    name = match.captured(1);
    return place;
}

int sectionNamed(const Model &model, const QString &name)
{
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        if (QString::fromStdString(model.section(i)->name) == name)
            return static_cast<int>(i);
    return -1;
}

} // namespace

void addWeightOptions(QCommandLineParser &parser)
{
    parser.addOption({QStringLiteral("weight"),
                      tr("Puts a weight on a section, in its middle or at X,Y in mm: \"Rib "
                         "4=350g\", \"Rib 4@10,25=0.35kg\". Can be repeated."),
                      QStringLiteral("NAME[@X,Y]=MASS")});
}

std::optional<int> hangWeights(const QCommandLineParser &parser, const Verb &verb,
                               Analysis &analysis)
{
    Model &model = analysis.model;
    for (const QString &text : parser.values(QStringLiteral("weight"))) {
        const qsizetype equals = text.lastIndexOf(u'=');
        if (equals < 0)
            return wrongUse(verb,
                            tr("--weight %1: expected NAME=MASS, as in \"Rib 4=350g\".").arg(text));
        const auto mass = massOf(text.mid(equals + 1));
        if (!mass)
            return wrongUse(verb, tr("--weight %1: expected a mass above 0 and up to 1000000 kg "
                                     "behind the =, with g, kg, oz or lb.")
                                      .arg(text));
        QString name = text.left(equals);
        std::optional<Vec2> place;
        int section = sectionNamed(model, name);
        if (section < 0) {
            place = placeIn(name);
            section = sectionNamed(model, name);
        }
        if (section < 0)
            return wrongUse(verb, tr("--weight %1: there is no section \"%2\".").arg(text, name));
        if (analysis.bodies.countOf(section) == 0)
            return wrongUse(verb,
                            tr("--weight %1: slits leave nothing of \"%2\".").arg(text, name));
        const Body &body = *analysis.bodies.of(section).front();
        Load weight;
        weight.id = LoadId{model.document.nextId++};
        weight.section = model.ref(static_cast<std::size_t>(section));
        weight.position = place.value_or(body.frame().toLocal(body.mass().centre));
        weight.mass = *mass;
        weight.isRepeated = false;
        model.document.loads.push_back(weight);
    }
    return std::nullopt;
}

} // namespace fff::cli
