#include "ui/docks/properties_header.h"

#include "core/assembly/joint_state.h"
#include "core/interaction/load_editing.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/session/operation_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/load_words.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/properties/joint_words.h"
#include "ui/view/heading_weight.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kLongestTitle = 224, kBelow = 12; // px; to what comes after it

} // namespace

PropertiesHeader::PropertiesHeader(Workbench &bench, QWidget *parent)
    : QWidget(parent), m_bench(bench)
{
    constexpr int kIconSize = 34;
    m_icon = new QLabel(this);
    m_icon->setObjectName(QStringLiteral("propertiesIcon"));
    m_icon->setFixedSize(kIconSize, kIconSize);
    m_icon->setAlignment(Qt::AlignCenter);
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("propertiesName"));
    m_name->setAccessibleName(tr("Name"));
    QFont bold = m_name->font();
    bold.setWeight(headingWeight());
    m_name->setFont(bold);
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("propertiesTitle"));
    m_title->setFont(bold);
    m_title->setMinimumHeight(m_name->sizeHint().height());
    m_kind = new QLabel(this);
    m_kind->setObjectName(QStringLiteral("propertiesKind"));
    m_kind->setForegroundRole(QPalette::PlaceholderText);
    m_kind->setWordWrap(true);
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, kBelow);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(6);
    grid->addWidget(m_icon, 0, 0);
    grid->addWidget(m_name, 0, 1);
    grid->addWidget(m_title, 0, 1);
    m_isOn = new QCheckBox(tr("On"), this);
    m_isOn->setObjectName(QStringLiteral("operationOn"));
    m_isOn->setToolTip(tr("Switched off, it makes nothing but keeps its settings"));
    auto *line = new QHBoxLayout;
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_kind, 1);
    line->addWidget(m_isOn, 0, Qt::AlignTop);
    grid->addLayout(line, 1, 1);
    connect(m_isOn, &QCheckBox::clicked, this, [this](bool isOn) {
        m_bench.run(QStringLiteral("operation.switch"), {{"on", isOn ? "true" : "false"}});
    });
    connect(m_name, &QLineEdit::editingFinished, this, &PropertiesHeader::rename);
    m_name->installEventFilter(this);
    refresh();
}

/// Esc takes back what was typed, before the field loses the focus and renames.
bool PropertiesHeader::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape)
        while (m_name->isUndoAvailable())
            m_name->undo();
    return QWidget::eventFilter(watched, event);
}

void PropertiesHeader::refresh()
{
    nameWhatIsSelected();
    const std::vector<int> sections = selectedSections(m_bench);
    const std::optional<JointRef> &joint = m_bench.interaction().selectedJoint();
    const Operation *operation =
        m_bench.session().model().document.find(m_bench.interaction().selectedOperation());
    const Load *load =
        m_bench.session().model().document.find(m_bench.interaction().selectedLoad());
    const QString icon = joint                    ? QStringLiteral("joint")
                         : operation              ? QString::fromStdString(operation->kind)
                         : load && load->isPush() ? QStringLiteral("push")
                         : load                   ? QStringLiteral("weight")
                         : sections.empty()       ? QStringLiteral("view_iso")
                                                  : QStringLiteral("section");
    m_icon->setPixmap(tintedPixmap(icon, 22, theme().accent, devicePixelRatioF()));

    QString name, kind;
    if (joint) {
        const Model &model = m_bench.session().model();
        if (const std::optional<JointState> state = jointState(model, *joint)) {
            const auto nameOf = [&model](int index) {
                return QString::fromStdString(model.section(static_cast<std::size_t>(index))->name);
            };
            //: the names of two sections that meet
            name = tr("%1 · %2", "joint").arg(nameOf(state->a), nameOf(state->b));
            kind = stateOf(*state);
        }
    } else if (operation) {
        name = QString::fromStdString(operation->name);
        kind = kindOf(*operation);
        m_isOn->setChecked(operation->isOn);
    } else if (load) {
        name = loadName(*load);
        //: %1 is a mass or a force, %2 the name of a section
        kind = tr("%1 on %2")
                   .arg(loadAmount(*load, locale()),
                        QString::fromStdString(m_bench.session().model().nameOf(load->section)));
    } else if (sections.empty()) {
        name = tr("Model");
        kind = tr("Nothing is selected");
    } else if (sections.size() == 1) {
        const Model &model = m_bench.session().model();
        name =
            QString::fromStdString(model.section(static_cast<std::size_t>(sections.front()))->name);
        kind = kindOf(sections.front());
    } else {
        name = tr("%n section(s)", nullptr, static_cast<int>(sections.size()));
        kind = tr("Changes apply to all of them");
    }
    const bool hasName =
        m_named.drawn.isValid() || m_named.operation.isValid() || m_namedLoad.isValid();
    m_isOn->setVisible(operation != nullptr);
    m_name->setVisible(hasName);
    m_title->setVisible(!hasName);
    m_title->setText(
        QFontMetrics(m_title->font()).elidedText(name, Qt::ElideMiddle, kLongestTitle));
    m_title->setToolTip(joint ? name : QString());
    if (!(m_name->hasFocus() && m_name->isModified()) && m_name->text() != name) {
        m_name->setText(name);
        m_name->setCursorPosition(0);
    }
    m_kind->setText(kind);
}

/// What was typed before another section was selected is the name of the one that was.
void PropertiesHeader::nameWhatIsSelected()
{
    const std::vector<int> sections = selectedSections(m_bench);
    SectionRef single;
    if (sections.size() == 1) {
        const SectionRef ref =
            m_bench.session().model().ref(static_cast<std::size_t>(sections.front()));
        if (ref.drawn.isValid()) // others are called after what they are made of
            single = ref;
    }
    single.operation = m_bench.interaction().selectedOperation();
    const LoadId load = m_bench.interaction().selectedLoad();
    if (single == m_named && load == m_namedLoad)
        return;
    rename();
    m_named = single;
    m_namedLoad = load;
}

/// "Cross lap · automatic"
QString PropertiesHeader::stateOf(const JointState &joint)
{
    const QString kind = jointKindName(joint.kind);
    if (joint.kind == JointKind::None && !joint.wanted.kind)
        return tr("They overlap");
    return joint.wanted.isEmpty() ? tr("%1 · automatic").arg(kind)
                                  : tr("%1 · set by hand").arg(kind);
}

QString PropertiesHeader::kindOf(int section) const
{
    const Model &model = m_bench.session().model();
    const auto index = static_cast<std::size_t>(section);
    const Analysis &analysis = m_bench.session().analysis();
    const int there = analysis.model.indexOf(model.ref(index));
    int joints = 0;
    for (const Joint &joint : analysis.assembly.joints)
        joints += joint.a == there || joint.b == there ? 1 : 0;
    const QString count = tr("%n joint(s)", nullptr, joints);
    if (const Operation *operation = model.document.find(model.ref(index).operation))
        //: %1 is the name of an operation, %2 a number of joints
        return tr("Made by %1 · %2").arg(QString::fromStdString(operation->name), count);
    const auto &link = model.section(index)->parent;
    const int on = link ? model.indexOf(link->section) : -1;
    return on < 0
               ? tr("Section · %1").arg(count)
               : tr("Section · on %1 · %2")
                     .arg(QString::fromStdString(model.section(static_cast<std::size_t>(on))->name),
                          count);
}

/// "Revolve · 13 sections · up to date"
QString PropertiesHeader::kindOf(const Operation &operation) const
{
    const QString kind = kindName(operation);
    if (!operation.isOn)
        //: %1 is the kind of an operation
        return tr("%1 · switched off").arg(kind);
    const OperationResult *result = m_bench.session().model().resultOf(operation.id);
    const bool fails =
        !result || std::any_of(result->notices.begin(), result->notices.end(),
                               [](const OperationNotice &n) { return isFailure(n); });
    if (fails)
        //: %1 is the kind of an operation
        return tr("%1 · makes nothing").arg(kind);
    //: %1 is the kind of an operation, %2 a number of sections
    return tr("%1 · %2 · up to date").arg(kind, tr("%n section(s)", nullptr, countOf(*result)));
}

void PropertiesHeader::rename()
{
    if (!m_name->isModified())
        return;
    m_name->setModified(false);
    const Document document = m_bench.session().committed().document;
    const Section *section = document.find(m_named.drawn);
    const Operation *operation = document.find(m_named.operation);
    const std::string name = m_name->text().trimmed().toStdString();
    if (operation && !name.empty() && name != operation->name)
        m_bench.commit(Step{steps::kRename, {Named{operation->name}}},
                       renameOperation(document, operation->id, name));
    if (const Load *load = document.find(m_namedLoad);
        load && name != load->name && name != loadName(*load).toStdString()) {
        Load next = *load;
        next.name = name; // none: it is called what it is
        m_bench.editSections(changedLoad(m_bench.session().committed(), next));
    }
    if (section && !name.empty() && name != section->name) {
        m_bench.commit(Step{steps::kRename, {Named{section->name}}},
                       renameSection(document, m_named.drawn, name));
    }
    refresh();
}

std::vector<int> selectedSections(const Workbench &bench)
{
    const Model &model = bench.session().model();
    std::vector<int> sections;
    for (const SectionRef &ref : bench.interaction().selection()) {
        if (const int index = model.indexOf(ref); index >= 0)
            sections.push_back(index);
    }
    return sections;
}

} // namespace fff::ui
