#include "ui/properties/instance_group.h"

#include "core/model/origin.h"
#include "ui/docks/link_row.h"
#include "ui/workbench.h"

#include <QCheckBox>
#include <QHBoxLayout>

namespace fff::ui {

InstanceGroup::InstanceGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(tr("Made by an operation"), parent), m_bench(bench)
{
    m_madeBy = new LinkRow;
    connect(m_madeBy, &LinkRow::clicked, this,
            [this] { m_bench.selectOperation(m_section.operation); });
    add(new EditorRow(tr("Made by"), "instanceMadeBy", m_madeBy, {}, this));
    m_source = new LinkRow;
    connect(m_source, &LinkRow::clicked, this, [this] { m_bench.select({m_origin}); });
    m_sourceRow = new EditorRow(tr("Image of"), "instanceSource", m_source, {}, this);
    m_sourceRow->setToolTip(tr("What is done to one of them is done to all"));
    add(m_sourceRow);

    m_leaveOut = new QCheckBox(tr("Leave this one out"));
    m_leaveOut->setObjectName(QStringLiteral("instanceLeaveOut"));
    // With it the operation is selected, where it can be brought back.
    connect(m_leaveOut, &QCheckBox::clicked, this, [this] {
        const OperationId operation = m_section.operation;
        m_bench.run(QStringLiteral("operation.exclude"), {{"state", "hidden"}});
        m_bench.selectOperation(operation);
    });
    m_detach = new QPushButton(tr("Detach"));
    m_detach->setObjectName(QStringLiteral("instanceDetach"));
    m_detach->setToolTip(tr("Make a drawn section of this one; its operation makes the others"));
    m_detach->setAutoDefault(false);
    connect(m_detach, &QPushButton::clicked, this, [this] {
        m_bench.run(QStringLiteral("operation.exclude"), {{"state", "detached"}});
        const auto &sections = m_bench.session().committed().document.sections;
        if (!sections.empty())
            m_bench.select({SectionRef(sections.back()->id)}); // what it became
    });
    auto *line = new QWidget(this);
    auto *row = new QHBoxLayout(line);
    row->setContentsMargins(0, 4, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_leaveOut, 1);
    row->addWidget(m_detach, 0);
    add(line);
}

void InstanceGroup::refresh()
{
    const Model &model = m_bench.session().model();
    const std::vector<SectionRef> &selected = m_bench.interaction().selection();
    m_section = selected.size() == 1 ? selected.front() : SectionRef();
    const Operation *operation = model.document.find(m_section.operation);
    setVisible(operation != nullptr);
    if (!operation)
        return;
    m_madeBy->setTexts({QString::fromStdString(operation->name)});
    m_leaveOut->setChecked(false); // one that is left out cannot be selected
    const std::optional<Origin> origin = originOf(model, m_section);
    m_sourceRow->setVisible(origin.has_value());
    m_origin = origin ? SectionRef(origin->section->id) : SectionRef();
    if (origin)
        m_source->setTexts({QString::fromStdString(origin->section->name)});
}

} // namespace fff::ui
