#include "ui/docks/values_dock.h"

#include "core/interaction/value_editing.h"
#include "core/io/listing.h"
#include "core/operations/value_dependents.h"
#include "core/session/message_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/preset_row.h"
#include "ui/docks/value_rows.h"
#include "ui/docks/value_trial_rows.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/stock_choice.h"
#include "ui/settings/settings.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <set>

namespace fff::ui {

namespace {

constexpr int kValuesMargin = 12, kBelowRows = 8; // px

} // namespace

ValuesDock::ValuesDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Values"), parent), m_bench(bench)
{
    dressDock(this, "valuesDock");
    auto *area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    area->setAccessibleName(tr("Values"));
    auto *page = new QWidget(area);
    m_purpose = new QLabel(page);
    m_purpose->setObjectName(QStringLiteral("valuesPurpose"));
    m_purpose->setWordWrap(true);
    m_purpose->setForegroundRole(QPalette::PlaceholderText);
    m_empty = new QLabel(page);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_problems = new QLabel(page);
    m_problems->setObjectName(QStringLiteral("valuesNotFollowing"));
    m_problems->setWordWrap(true);
    m_problems->setTextFormat(Qt::PlainText);
    m_add = new QPushButton(themedIcon(QStringLiteral("plus")), tr("New value"), page);
    m_add->setObjectName(QStringLiteral("valueAdd"));
    m_add->setAutoDefault(false);
    connect(m_add, &QPushButton::clicked, this, &ValuesDock::addNew);
    m_handOn = new QPushButton(page);
    m_handOn->setObjectName(QStringLiteral("valuesHandOn"));
    m_handOn->setAutoDefault(false);
    connect(m_handOn, &QPushButton::clicked, this,
            [this] { m_bench.run(QStringLiteral("value.handOn")); });
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(kValuesMargin, kBelowRows, kValuesMargin, kValuesMargin);
    column->setSpacing(kBelowRows);
    column->addWidget(m_purpose);
    column->addWidget(m_empty);
    m_presets = new PresetRow(bench, page);
    column->addWidget(m_presets);
    connect(m_presets, &PresetRow::namingBegun, area,
            [this, area] { area->ensureWidgetVisible(m_presets); });
    m_rows = new ValueRows(bench, page);
    connect(m_rows, &ValueRows::hovered, this, &ValuesDock::light);
    column->addWidget(m_rows);
    column->addWidget(m_problems);
    m_trials = new ValueTrialRows(bench, page);
    column->addWidget(m_trials);
    column->addWidget(m_add);
    column->addWidget(m_presets->first());
    column->addStretch(1);
    column->addWidget(m_handOn); // apart: what it does is no edit of the values
    area->setWidget(page);
    setWidget(area);
    connect(&bench.session(), &Session::modelChanged, this, &ValuesDock::refresh);
    connect(&bench.session(), &Session::committedChanged, m_rows, &ValueRows::forgetRefusals);
    connect(&settings(), &Settings::unitChanged, this, &ValuesDock::refresh);
    refresh();
}

void ValuesDock::addNew()
{
    const Document &document = m_bench.session().committed().document;
    Value value;
    //: the name of a new value, one word of letters
    value.name = freeValueName(document.values, tr("value").toStdString());
    value.kind = ValueKind::Length;
    value.typed = "100 mm";
    value.isShown = true;
    show();
    if (!tryEdit(m_bench, valueAdded(document, std::move(value))).isEmpty())
        return;
    refresh();
    m_rows->beginNaming(m_bench.session().committed().document.values.list.back()->value.id);
}

void ValuesDock::setAdjustsOnly(bool only)
{
    m_adjustsOnly = only;
    setDockFixed(*this, only);
    m_presets->setAdjustsOnly(only);
    m_rows->setAdjustsOnly(only);
    m_trials->setOffered(!only);
    refresh();
}

QString ValuesDock::notFollowing() const
{
    QStringList lines;
    for (const DrivingError &error : m_bench.session().model().evaluation.drivingErrors)
        lines += messageText(error.sentence, unitsInUse());
    return lines.join(u'\n');
}

void ValuesDock::refresh()
{
    if (!isVisible())
        return;
    m_presets->refresh();
    m_rows->refresh();
    refreshAround();
    m_trials->refresh();
    const QString problems = notFollowing();
    m_problems->setVisible(!problems.isEmpty());
    m_problems->setText(problems);
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, theme().problem);
    m_problems->setPalette(colours);
}

/// What the parts are cut from, which whoever adjusts the design has to have at hand.
QString ValuesDock::stocks() const
{
    const Model &model = m_bench.session().model();
    std::set<StockId> used;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        used.insert(model.section(i)->stock);
    QStringList names;
    for (const StockId id : used)
        if (const Stock *stock = model.document.find(id))
            names += stockText(*stock, locale());
    return separated(names);
}

/// What stands above and below the rows.
void ValuesDock::refreshAround()
{
    const bool hasShown = hasShownValue(m_bench.session().model().document.values);
    m_purpose->setVisible(m_adjustsOnly && hasShown);
    if (m_purpose->isVisibleTo(this)) {
        const QString from = stocks();
        m_purpose->setText(
            tr("This design is made to be adjusted: set its values, then export "
               "it. Drag in the view to turn it.") +
            //: %1 are stocks: "Birch plywood 3 mm"
            (from.isEmpty() ? QString() : u' ' + tr("It is cut from %1.").arg(from)));
    }
    m_empty->setVisible(m_rows->isEmpty());
    m_empty->setText(
        m_adjustsOnly
            ? tr("There is nothing to adjust in this design.")
            : tr("Give a number a name: any field can use it, also in sums such as = 2*gap."));
    m_add->setVisible(!m_adjustsOnly);
    m_handOn->setVisible((m_adjustsOnly || hasShown) && m_bench.commands().isShown("value.handOn"));
    m_handOn->setText(m_adjustsOnly ? tr("Edit the design") : tr("Share for adjusting"));
    m_handOn->setToolTip(m_adjustsOnly
                             ? tr("Bring back drawing and all panels; when it is saved now, the "
                                  "file opens like that.")
                             : tr("Whoever opens the saved model sees the view, the shown values "
                                  "and Export, and nothing else."));
}

void ValuesDock::light(ValueId value, bool isOver)
{
    if (!isOver && m_lit != value)
        return;
    m_lit = isOver ? value : ValueId();
    m_bench.setOutlined(isOver ? dependents(m_bench.session().model(), value)
                               : std::vector<SectionRef>());
}

/// It is not kept up to date while nobody sees it.
void ValuesDock::showEvent(QShowEvent *event)
{
    QDockWidget::showEvent(event);
    refresh();
}

void ValuesDock::hideEvent(QHideEvent *event)
{
    light(m_lit, false);
    QDockWidget::hideEvent(event);
}

void ValuesDock::refreshColours()
{
    refresh();
}

} // namespace fff::ui
