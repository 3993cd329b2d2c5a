#include "ui/properties/magnet_group.h"

#include "core/interaction/magnet_editing.h"
#include "core/model/magnet_edits.h"
#include "ui/bench/workbench.h"

#include <QCheckBox>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr LengthEdit::Range kMagnetReach{kLeastMagnet, kMostMagnet, 1.0, 1, 3};

} // namespace

MagnetGroup::MagnetGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(tr("Template"), parent), m_bench(bench)
{
    m_pulls = new QCheckBox(this);
    connect(m_pulls, &QCheckBox::clicked, this, [this] {
        m_bench.run(QStringLiteral("section.pull"),
                    {{"on", m_pulls->isChecked() ? "true" : "false"}});
    });
    auto *pulls = new EditorRow(tr("Pulled in"), "sectionPulls", m_pulls, {}, this);
    pulls->setToolTip(tr("Bend the template into the plane of this section, so that the guides of "
                         "others follow what was drawn"));
    add(pulls);
    m_reach = new LengthRow(
        tr("From within"), "sectionPullReach", kMagnetReach,
        [this]() -> std::optional<double> {
            const Document &document = m_bench.session().model().document;
            std::optional<double> common;
            for (const SectionRef &section : m_bench.interaction().selection()) {
                const std::optional<double> radius = magnetOf(document, section);
                if (!radius || (common && *common != *radius))
                    return std::nullopt;
                common = radius;
            }
            return common;
        },
        [this](double radius) {
            m_bench.editSections(magnetsChanged(m_bench.session().committed(),
                                                m_bench.interaction().selection(), radius));
        },
        this);
    add(m_reach);
}

void MagnetGroup::refresh()
{
    const Document &document = m_bench.session().model().document;
    const std::vector<SectionRef> &selected = m_bench.interaction().selection();
    const bool isThere = canPullTemplates(document) && !selected.empty();
    setVisible(isThere);
    if (!isThere)
        return;
    const auto on = std::count_if(selected.begin(), selected.end(), [&](const SectionRef &section) {
        return magnetOf(document, section).has_value();
    });
    m_pulls->setTristate(on > 0 && on < std::ssize(selected));
    m_pulls->setCheckState(on == 0                      ? Qt::Unchecked
                           : on == std::ssize(selected) ? Qt::Checked
                                                        : Qt::PartiallyChecked);
    m_reach->setVisible(on > 0);
    m_reach->refresh();
}

} // namespace fff::ui
