#include "ui/properties/instance_group.h"

#include "core/model/origin.h"
#include "core/operations/operation_kind.h"
#include "ui/bench/workbench.h"
#include "ui/properties/link_row.h"

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
    add(m_sourceRow);

    m_leaveOut = new QCheckBox(tr("Leave this one out"));
    m_leaveOut->setObjectName(QStringLiteral("instanceLeaveOut"));
    connect(m_leaveOut, &QCheckBox::clicked, this, [this] {
        m_bench.run(QStringLiteral("operation.exclude"), {{"state", "hidden"}});
    });
    m_detach = new QPushButton(tr("Detach"));
    m_detach->setObjectName(QStringLiteral("instanceDetach"));
    m_detach->setToolTip(
        tr("Turn this one into a drawn section; its operation still makes the others"));
    m_detach->setAutoDefault(false);
    connect(m_detach, &QPushButton::clicked, this, [this] {
        m_bench.run(QStringLiteral("operation.exclude"), {{"state", "detached"}});
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
    // What is drawn for it: an image's own source, else the first thing that is repeated.
    const std::optional<Origin> origin = originOf(model, m_section);
    const OperationInput *input = firstInput(*operation);
    m_origin = origin ? SectionRef(origin->section->id) : input ? input->section : SectionRef();
    const std::string name = model.nameOf(m_origin);
    m_sourceRow->setVisible(!name.empty());
    m_sourceRow->setName(origin ? tr("Image of") : tr("Made from"));
    m_sourceRow->setToolTip(origin ? tr("Changes to one of them apply to all")
                                   : tr("Redraw it; everything made from it follows"));
    m_source->setTexts({QString::fromStdString(name)});
}

} // namespace fff::ui
