#include "tests/core/physics/reference_index.h"

#include "tests/core/physics/reference_json.h"

#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>

namespace fff::test {

namespace {

constexpr double kPercent = 0.01;

const QRegularExpression &bandPattern()
{
    static const QRegularExpression pattern(
        key(R"(\[\s*([-+]?[\d.]+)\s*%?\s*,\s*([-+]?[\d.]+)\s*%\s*\])"));
    return pattern;
}
const QRegularExpression &percentPattern()
{
    static const QRegularExpression pattern(key(R"((\d*\.?\d+)\s*%)"));
    return pattern;
}
const QRegularExpression &newtonPattern()
{
    static const QRegularExpression pattern(key(R"(within\s+(\d*\.?\d+)\s*N\b)"));
    return pattern;
}
const QRegularExpression &peakPattern()
{
    static const QRegularExpression pattern(key(R"(\bpeak\s+(\d*\.?\d+))"));
    return pattern;
}
const QRegularExpression &clauseEnd()
{
    static const QRegularExpression pattern(key(R"(;|\.\s)"));
    return pattern;
}

std::optional<double> numberIn(const QString &text, const QRegularExpression &pattern)
{
    const QRegularExpressionMatch match = pattern.match(text);
    return match.hasMatch() ? std::optional(match.captured(1).toDouble()) : std::nullopt;
}

/// A number (±), two of them, or a text with either.
std::optional<Band> bandOf(const QJsonValue &value)
{
    if (value.isDouble())
        return Band{-value.toDouble(), value.toDouble()};
    if (value.isArray() && value.toArray().size() == 2)
        return Band{value.toArray()[0].toDouble(), value.toArray()[1].toDouble()};
    const QString text = value.toString();
    if (const QRegularExpressionMatch match = bandPattern().match(text); match.hasMatch())
        return Band{kPercent * match.captured(1).toDouble(),
                    kPercent * match.captured(2).toDouble()};
    if (const auto percent = numberIn(text, percentPattern()))
        return Band{-kPercent * *percent, kPercent * *percent};
    return {};
}

/// Not to be judged by what it says: for information, or beyond what the method can know.
bool isToldOnly(const QString &clause)
{
    for (const char *word : {"informational", "outside beam theory", "not comparable",
                             "not covered", "not required", "flag"}) {
        if (clause.contains(key(word), Qt::CaseInsensitive))
            return true;
    }
    return false;
}

std::vector<std::string> namesOfCuts(const ReferenceCase &found)
{
    std::vector<std::string> names;
    for (const ReferenceTruth *truth : {&found.truth, &found.contact, &found.contactWithPlay}) {
        for (const ReferenceCut &cut : truth->cuts)
            names.push_back(cut.name);
    }
    return names;
}

/// The cuts that a clause speaks of: by their whole names, else by the first words of them.
std::vector<std::string> named(const QString &clause, const std::vector<std::string> &cuts)
{
    const auto holds = [&](const QString &word) {
        const QRegularExpression pattern(key("\\b") + QRegularExpression::escape(word) +
                                         key("\\b"));
        return clause.contains(pattern);
    };
    std::vector<std::string> whole, first;
    for (const std::string &cut : cuts) {
        const QString name = QString::fromStdString(cut);
        if (holds(name))
            whole.push_back(cut);
        else if (holds(name.section(QLatin1Char('_'), 0, 0)))
            first.push_back(cut);
    }
    return whole.empty() ? first : whole;
}

void readBeamText(const QString &text, const std::vector<std::string> &cuts, Tolerances &found)
{
    for (const QString &clause : text.split(clauseEnd())) {
        const std::optional<Band> band = bandOf(clause);
        const std::vector<std::string> spoken = named(clause, cuts);
        const bool isTold = isToldOnly(clause);
        if ((!band && !isTold) || clause.contains(key("must fail")))
            continue;
        if (spoken.empty()) {
            found.beam = band.value_or(found.beam);
            found.isBeamTold = found.isBeamTold || isTold;
        }
        for (const std::string &cut : spoken) {
            found.cuts[cut].beam = band;
            found.cuts[cut].isTold = isTold;
        }
    }
}

void readPlateText(const QString &text, const std::vector<std::string> &cuts, Tolerances &found)
{
    for (const QString &clause : text.split(clauseEnd())) {
        const auto percent = numberIn(clause, percentPattern());
        if (clause.contains(key("peak"))) {
            if (const auto peak = numberIn(clause, peakPattern()); peak && percent) {
                found.peak = *peak;
                found.peakShare = kPercent * *percent;
            }
        } else if (const auto band = bandOf(clause)) {
            const std::vector<std::string> spoken = named(clause, cuts);
            if (spoken.empty())
                found.plate = band->high;
            for (const std::string &cut : spoken)
                found.cuts[cut].plate = band;
        }
    }
}

void readElasticText(const QString &text, Tolerances &found)
{
    static const QRegularExpression contact(key(R"(truth_contact(?!_play))"));
    found.isElasticNamed = !text.isEmpty();
    found.isElasticOfPlay = text.contains(key("truth_contact_play"));
    found.isElasticOfContact = text.contains(contact);
    if (const auto percent = numberIn(text, percentPattern()))
        found.elastic = kPercent * *percent;
    found.elasticNewton = numberIn(text, newtonPattern());
}

/// One key of a table of tolerances. False: nobody knows it.
bool readKey(const QString &name, const QJsonValue &value, const std::vector<std::string> &cuts,
             Tolerances &found)
{
    const std::pair<const char *, double *> numbers[] = {
        {"mass_rel", &found.mass},
        {"com_mm", &found.centre},
        {"reactions_determinate_rel", &found.reaction},
        {"joint_wrench_determinate_rel", &found.wrench},
        {"resultant_mm", &found.resultant},
        {"margin_mm", &found.resultant},
        {"fem_mode_rel", &found.plate},
        {"elastic_rel", &found.elastic},
        {"peak_rel", &found.peakShare}};
    for (const auto &[known, number] : numbers) {
        if (name == key(known) && value.isDouble()) {
            *number = value.toDouble();
            return true;
        }
    }
    if (name == key("sigma_lin_rel"))
        found.beam = bandOf(value).value_or(found.beam);
    else if (name == key("beam") || name == key("sigma_lin"))
        readBeamText(value.toString(), cuts, found);
    else if (name == key("fem"))
        readPlateText(value.toString(), cuts, found);
    else if (name == key("elastic"))
        readElasticText(value.toString(), found);
    else if (const auto cut = std::find(cuts.begin(), cuts.end(), name.toStdString());
             cut != cuts.end()) {
        found.cuts[*cut].beam = bandOf(value);
        found.cuts[*cut].isTold = isToldOnly(value.toString());
    } else
        return name == key("rigid") || name == key("verdict"); // what is required of all
    return true;
}

void readTable(const QJsonValue &table, const std::vector<std::string> &cuts, Tolerances &found)
{
    const QJsonObject given = table.toObject();
    for (const QJsonObject &keys : {given[key("default")].toObject(), given}) {
        for (auto i = keys.begin(); i != keys.end(); ++i) {
            if (!i.value().isObject() && !readKey(i.key(), i.value(), cuts, found))
                found.unknown.push_back(i.key().toStdString());
        }
    }
}

} // namespace

Band Tolerances::beamOf(const std::string &cut) const
{
    const auto rule = cuts.find(cut);
    Band band = rule != cuts.end() ? rule->second.beam.value_or(beam) : beam;
    // Where right statics is known to be off, ours may be off as far, and what it may be besides.
    if (const auto known = statics.find(cut); known != statics.end()) {
        band.low = std::min(band.low, known->second - 1.0 + std::min(0.0, band.low));
        band.high = std::max(band.high, known->second - 1.0 - std::min(0.0, band.low));
    }
    return band;
}

Band Tolerances::plateOf(const std::string &cut) const
{
    const auto rule = cuts.find(cut);
    const Band all{-plate, plate};
    return rule != cuts.end() ? rule->second.plate.value_or(all) : all;
}

bool Tolerances::isTold(const std::string &cut) const
{
    const auto rule = cuts.find(cut);
    return isBeamTold || (rule != cuts.end() && rule->second.isTold);
}

ReferenceIndex::ReferenceIndex(const QDir &folder)
{
    QFile file(folder.filePath(key("index.json")));
    if (!file.open(QIODevice::ReadOnly))
        return;
    const QJsonObject index = QJsonDocument::fromJson(file.readAll()).object();
    for (const QJsonValue &value : index[key("cases")].toArray())
        m_entries[value.toObject()[key("id")].toString()] = value;
}

Tolerances ReferenceIndex::of(const ReferenceCase &found) const
{
    Tolerances tolerances;
    const QJsonObject entry = m_entries[QString::fromStdString(found.id)].toObject();
    const QString stage = entry[key("stage1")].toString();
    tolerances.isIndeterminate = stage == key("indeterminate");
    tolerances.isDeterminate = stage == key("determinate");
    tolerances.isSymmetric = stage.contains(key("symmetry"));
    const std::vector<std::string> cuts = namesOfCuts(found);
    readTable(found.json[key("tolerances")], cuts, tolerances);
    readTable(entry[key("tolerances")], cuts, tolerances);
    for (const QString &clause : QString::fromStdString(found.notes).split(clauseEnd())) {
        if (isToldOnly(clause))
            for (const std::string &cut : named(clause, cuts))
                tolerances.cuts[cut].isTold = true;
    }
    const QJsonObject statics = entry[key("beam_statics_over_fem_sigma_lin")].toObject();
    for (auto i = statics.begin(); i != statics.end(); ++i)
        tolerances.statics[i.key().toStdString()] = i.value().toDouble();
    return tolerances;
}

} // namespace fff::test
