#include "tests/core/physics/reference_case.h"
#include "tests/core/physics/reference_json.h"

namespace fff::test {

namespace {

/// What the file says in words. Of several words that are there the first counts.
std::optional<Balance> balanceOf(const QString &verdict)
{
    const std::pair<const char *, Balance> words[] = {
        {"float", Balance::Floating},       {"no contact", Balance::NoContact},
        {"toppl", Balance::Topples},        {"line support", Balance::LineSupport},
        {"unstable", Balance::LineSupport}, {"slide", Balance::Slides},
        {"mechanism", Balance::Mechanism},  {"stand", Balance::Stands}};
    for (const auto &[word, balance] : words) {
        if (verdict.contains(key(word), Qt::CaseInsensitive))
            return balance;
    }
    return {};
}

std::map<std::string, double> numbersOf(const QJsonObject &json)
{
    std::map<std::string, double> numbers;
    for (auto i = json.begin(); i != json.end(); ++i) {
        if (i.value().isDouble())
            numbers[i.key().toStdString()] = i.value().toDouble();
    }
    return numbers;
}

std::vector<std::vector<std::string>> groupsOf(const QJsonValue &value)
{
    std::vector<std::vector<std::string>> groups;
    for (const QJsonValue &group : value.toArray()) {
        groups.emplace_back();
        for (const QJsonValue &id : group.toArray())
            groups.back().push_back(textOf(id));
    }
    return groups;
}

/// A point of the ground, given in space or by the two coordinates that are not its normal's.
Vec3 groundPointOf(const QJsonValue &value, const Structure &structure, const Vec3 &ground)
{
    const QJsonArray array = value.toArray();
    if (array.size() == 3)
        return vectorOf(value);
    Vec3 point = ground;
    int given = 0;
    Eigen::Index height = 0;
    structure.up.cwiseAbs().maxCoeff(&height);
    for (int i = 0; i < 3; ++i) {
        if (i != height)
            point[i] = array.at(given++).toDouble();
    }
    return point;
}

int placeOf(const ReferenceCase &found, const QJsonValue &id)
{
    for (std::size_t i = 0; i < found.sections.size(); ++i) {
        if (found.sections[i].id == textOf(id))
            return static_cast<int>(i);
    }
    return found.sections.size() == 1 ? 0 : -1; // of a single one files need not say
}

/// Where a cut lies may be said once for all solvers: with the first truth.
std::vector<ReferenceCut> cutsOf(const QJsonObject &json, const ReferenceCase &found)
{
    std::map<QString, QJsonObject> places;
    for (const QJsonValue &value : found.json[key("truth")].toObject()[key("cuts")].toArray())
        places[value.toObject()[key("name")].toString()] = value.toObject();
    std::vector<ReferenceCut> cuts;
    for (const QJsonValue &value : json[key("cuts")].toArray()) {
        const QJsonObject cut = value.toObject();
        const QJsonObject &place =
            cut.contains(key("p0")) ? cut : places[cut[key("name")].toString()];
        if (!place.contains(key("p0")) || !place.contains(key("p1")))
            continue;
        cuts.push_back({textOf(cut[key("name")]), placeOf(found, place[key("section")]),
                        pointOf(place[key("p0")]), pointOf(place[key("p1")]),
                        numbersOf(cut[key("fem")].toObject()),
                        numbersOf(cut[key("statics_resultant")].toObject())});
        if (cuts.back().section < 0)
            cuts.pop_back();
    }
    return cuts;
}

} // namespace

std::optional<double> ReferenceCut::said(const char *quantity) const
{
    const auto number = fem.find(quantity);
    return number != fem.end() ? std::optional(number->second) : std::nullopt;
}

ReferenceTruth readReferenceTruth(const ReferenceCase &found, const char *name)
{
    const QJsonObject json = found.json[key(name)].toObject();
    const Vec3 ground = vectorOf(found.json[key("ground")].toObject()[key("point_mm")]);
    ReferenceTruth truth;
    if (json.contains(key("mass_kg")))
        truth.mass = json[key("mass_kg")].toDouble();
    if (json.contains(key("com_mm")))
        truth.centre = vectorOf(json[key("com_mm")]);
    for (const QJsonValue &reaction : json[key("contact_reactions_N")].toArray())
        truth.reactions.push_back(reaction.isDouble()
                                      ? Vec3(reaction.toDouble() * found.structure.up)
                                      : vectorOf(reaction));
    const QJsonObject joints = json[key("joint_wrenches")].toObject();
    for (auto i = joints.begin(); i != joints.end(); ++i) {
        const QJsonObject wrench = i.value().toObject();
        truth.joints[i.key().toStdString()] = {
            vectorOf(wrench[key("force_on_a_N")]),
            vectorOf(wrench[key("moment_on_a_about_point_Nmm")])};
    }
    truth.cuts = cutsOf(json, found);
    truth.balance = balanceOf(json[key("verdict")].toString());
    if (json.contains(key("margin_mm")))
        truth.margin = json[key("margin_mm")].toDouble();
    if (json.contains(key("resultant_point_mm")))
        truth.resultant = groundPointOf(json[key("resultant_point_mm")], found.structure, ground);
    truth.components = groupsOf(json[key("components")]);
    truth.unsupported = groupsOf(json[key("unsupported")]);
    return truth;
}

} // namespace fff::test
