#include "ui/docks/preset_row.h"

#include "core/interaction/value_editing.h"
#include "core/values/presets.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/property_rows.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

namespace fff::ui {

namespace {

enum PresetColumn { kPresetLabel, kPresetBox, kPresetKeep, kPresetRemove, kPresetColumns };

/// The index of what is set now, or -1.
Choices presetChoices(const Values &values)
{
    Choices choices;
    const Preset *used = presetInUse(values);
    for (const PresetPointer &preset : values.presets) {
        if (preset.get() == used)
            choices.current = static_cast<int>(choices.all.size());
        choices.all.push_back({QString::fromStdString(preset->name), QColor()});
    }
    return choices;
}

} // namespace

PresetRow::PresetRow(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    //: a set of settings of a design's values that has a name, such as A5
    m_label = new QLabel(tr("Preset"), this);
    m_box = new ChoiceBox(this);
    m_box->setObjectName(QStringLiteral("presetBox"));
    m_box->setAccessibleName(tr("Preset"));
    //: in place of a preset's name: what is set is none of them
    m_box->setPlaceholderText(tr("changed"));
    connect(m_box, &QComboBox::activated, this, &PresetRow::choose);
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("presetName"));
    m_name->setAccessibleName(tr("Name of the preset"));
    //: names of presets as they could be
    m_name->setPlaceholderText(tr("A5, four shelves …"));
    m_name->installEventFilter(this);
    m_name->hide();
    m_keep = smallButton(QStringLiteral("plus"), "presetKeep",
                         tr("Keep what is set now as a preset"), this);
    connect(m_keep, &QToolButton::clicked, this, &PresetRow::beginNaming);
    m_remove = smallButton(QStringLiteral("trash"), "presetDelete", tr("Delete this preset"), this);
    connect(m_remove, &QToolButton::clicked, this, &PresetRow::remove);
    m_first = new QPushButton(tr("Keep as a preset"), this);
    m_first->setObjectName(QStringLiteral("presetFirst"));
    m_first->setAutoDefault(false);
    m_first->setToolTip(tr("Gives what is set now a name, such as A5, to come back to it"));
    connect(m_first, &QPushButton::clicked, this, &PresetRow::beginNaming);
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("presetProblem"));
    m_problem->setWordWrap(true);
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->hide();
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    grid->addWidget(m_label, 0, kPresetLabel);
    grid->addWidget(m_box, 0, kPresetBox);
    grid->addWidget(m_name, 0, kPresetBox);
    grid->addWidget(m_keep, 0, kPresetKeep);
    grid->addWidget(m_remove, 0, kPresetRemove);
    grid->addWidget(m_problem, 1, kPresetLabel, 1, kPresetColumns);
    grid->setColumnStretch(kPresetBox, 1);
}

void PresetRow::setAdjustsOnly(bool only)
{
    m_adjustsOnly = only;
    endNaming();
}

void PresetRow::refresh()
{
    const Values &values = m_bench.session().model().document.values;
    const bool hasPresets = !values.presets.empty();
    const bool canKeep = !m_adjustsOnly && !takenPreset(values, {}).settings.empty();
    m_isNaming = m_isNaming && canKeep;
    const Choices choices = presetChoices(values);
    m_box->setChoices(choices);
    m_label->setVisible(hasPresets || m_isNaming);
    m_box->setVisible(hasPresets && !m_isNaming);
    m_name->setVisible(m_isNaming);
    m_keep->setVisible(hasPresets && canKeep && !m_isNaming);
    // What is set already under a name needs no second one.
    m_keep->setEnabled(choices.current < 0);
    m_remove->setVisible(hasPresets && !m_adjustsOnly && !m_isNaming);
    m_remove->setEnabled(choices.current >= 0);
    m_first->setVisible(!hasPresets && canKeep && !m_isNaming);
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, theme().problem);
    m_problem->setPalette(colours);
    setVisible(hasPresets || m_isNaming);
}

void PresetRow::say(const QString &why)
{
    m_problem->setText(why);
    m_problem->setVisible(!why.isEmpty());
}

void PresetRow::choose(int index)
{
    const Document &document = m_bench.session().committed().document;
    const auto &presets = document.values.presets;
    if (index >= 0 && index < static_cast<int>(presets.size()))
        say(tryEdit(m_bench,
                    presetTaken(document, presets[static_cast<std::size_t>(index)]->name)));
    refresh(); // what was refused is not chosen
}

void PresetRow::beginNaming()
{
    m_isNaming = true;
    m_name->clear();
    say({});
    refresh();
    Q_EMIT namingBegun();
    m_name->setFocus(Qt::OtherFocusReason);
}

void PresetRow::endNaming()
{
    m_isNaming = false;
    say({});
    refresh();
}

void PresetRow::keep()
{
    const Document &document = m_bench.session().committed().document;
    const QString why =
        tryEdit(m_bench, presetKept(document, m_name->text().trimmed().toStdString()));
    if (why.isEmpty()) {
        endNaming();
        m_box->setFocus(Qt::OtherFocusReason);
    } else {
        say(why);
    }
}

void PresetRow::remove()
{
    const Document &document = m_bench.session().committed().document;
    if (const Preset *used = presetInUse(document.values))
        say(tryEdit(m_bench, presetRemoved(document, used->name)));
    refresh();
}

bool PresetRow::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_name || !m_isNaming)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::FocusOut && m_name->text().trimmed().isEmpty() &&
        static_cast<QFocusEvent *>(event)->reason() != Qt::PopupFocusReason &&
        static_cast<QFocusEvent *>(event)->reason() != Qt::ActiveWindowFocusReason)
        endNaming();
    const bool isKey =
        event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    const int key = isKey ? static_cast<QKeyEvent *>(event)->key() : 0;
    if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter)
        return QWidget::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::KeyPress && key == Qt::Key_Escape)
        endNaming();
    else if (event->type() == QEvent::KeyPress)
        keep();
    return true;
}

} // namespace fff::ui
