#include "ui/sheets/sheets_dock.h"

#include "core/interaction/sheet_editing.h"
#include "core/io/error_text.h"
#include "core/session/scheduler.h"
#include "core/session/sheet_nesting.h"
#include "ui/base/rich_text.h"
#include "ui/bench/cutting_words.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/export_choices.h"
#include "ui/dialogs/export_remarks.h"
#include "ui/docks/dock_title.h"
#include "ui/properties/link_row.h"
#include "ui/properties/segmented_box.h"
#include "ui/settings/settings.h"
#include "ui/sheets/layout_group.h"
#include "ui/sheets/sheets_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr int kRowsWidth = 314, kBarWidth = 250; // px
constexpr int kThousand = 1000;                  // steps of the bar

/// Sections with a part that fits no sheet.
std::vector<SectionRef> tooLargeOn(const SheetsContent &content)
{
    std::vector<SectionRef> sections;
    for (const SheetFacts &facts : content.facts)
        if (facts.isTooLarge)
            for (const PartOnSheet &part : facts.parts)
                sections.push_back(part.section);
    return sections;
}

} // namespace

SheetsDock::SheetsDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Sheets"), parent), m_bench(bench)
{
    dressDock(this, "sheetsDock");
    bench.nesting().setOptions(rememberedChoices().nesting());
    m_work = new CuttingWork(bench.session(), bench.nesting(), this);
    auto *content = new QWidget(this);
    content->setMinimumHeight(kLeastHeight);
    m_view = new SheetsView(content);
    auto *rows = new QScrollArea(content);
    rows->setFrameShape(QFrame::NoFrame);
    rows->setWidgetResizable(true);
    rows->setFixedWidth(kRowsWidth);
    rows->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rows->setFocusPolicy(Qt::NoFocus);
    auto *page = new QWidget(rows);
    auto *pageColumn = new QVBoxLayout(page);
    pageColumn->setContentsMargins(12, 0, 12, 8);
    m_layoutRows = new LayoutGroup(bench, page);
    pageColumn->addWidget(m_layoutRows);
    pageColumn->addStretch(1);
    rows->setWidget(page);
    auto *middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addWidget(m_view, 1);
    middle->addWidget(rows);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeHead());
    column->addLayout(middle, 1);
    column->addWidget(makeFoot());
    setWidget(content);

    connect(m_view, &SheetsView::sectionHovered, this, &SheetsDock::light);
    connect(m_view, &SheetsView::placed, this, [this](const PinnedPlace &place, bool isByKey) {
        edit(placedOnSheet(m_bench.session().committed(), place,
                           isByKey ? PlacingBy::Key : PlacingBy::Hand));
    });
    connect(m_view, &SheetsView::pinned, this, [this](const std::vector<PinnedPlace> &places) {
        edit(pinnedOnSheets(m_bench.session().committed(), places));
    });
    connect(m_view, &SheetsView::letGo, this, [this](const std::vector<SectionRef> &sections) {
        edit(unpinned(m_bench.session().committed(), sections));
    });
    connect(m_view, &SheetsView::hinted, this, &SheetsDock::hinted);
    connect(m_view, &SheetsView::refused, this, &SheetsDock::say);
    connect(m_view, &SheetsView::selected, &bench,
            [this](const std::vector<SectionRef> &sections) { m_bench.select(sections); });
    connect(&bench, &Workbench::selectionChanged, this,
            [this] { m_view->setSelected(m_bench.interaction().selection()); });
    connect(&bench, &Workbench::viewChanged, this, &SheetsDock::followView);
    connect(m_work, &CuttingWork::changed, this, &SheetsDock::refresh);
    connect(&bench.nesting(), &SheetNesting::progressed, this, &SheetsDock::refreshHead);
    connect(&settings(), &Settings::unitChanged, this, &SheetsDock::refresh);
    connect(&settings(), &Settings::exportChanged, this, [this] {
        m_work->setLook(rememberedChoices().cuts());
        refresh();
    });
    refresh();
}

QWidget *SheetsDock::makeHead()
{
    auto *head = new QWidget(this);
    m_level = new SegmentedBox({tr("Quick"), tr("Good"), tr("Best")}, head);
    m_level->setObjectName(QStringLiteral("sheetsLevel"));
    m_level->setSpoken(tr("How well parts are laid"));
    m_level->setToolTip(tr("Quick lays all parts again. Good takes about ten seconds. Best goes on "
                           "until you stop it."));
    m_bar = new QProgressBar(head);
    m_bar->setObjectName(QStringLiteral("sheetsBar"));
    m_bar->setFixedWidth(kBarWidth);
    m_bar->setRange(0, kThousand);
    m_state = new QLabel(head);
    m_state->setObjectName(QStringLiteral("sheetsState"));
    m_state->setForegroundRole(QPalette::PlaceholderText);
    m_stop = new QPushButton(tr("Stop"), head);
    m_stop->setObjectName(QStringLiteral("sheetsStop"));
    m_tooLarge = new QWidget(head);
    m_tooLargeText = new QLabel(m_tooLarge);
    m_tooLargeText->setObjectName(QStringLiteral("sheetsTooLarge"));
    m_split = new LinkRow(m_tooLarge);
    m_split->setObjectName(QStringLiteral("sheetsSplit"));
    m_split->setTexts({tr("Split by Grid")});
    auto *large = new QHBoxLayout(m_tooLarge);
    large->setContentsMargins(0, 0, 0, 0);
    large->setSpacing(8);
    large->addWidget(m_tooLargeText);
    large->addWidget(m_split, 1);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_level);
    row->addWidget(m_bar);
    row->addWidget(m_state);
    row->addWidget(m_stop);
    row->addStretch(1);
    auto *column = new QVBoxLayout(head);
    column->setContentsMargins(12, 6, 12, 6);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(m_tooLarge);
    connect(m_level, &SegmentedBox::activated, this,
            [this](int level) { m_bench.nesting().nest(static_cast<NestLevel>(level)); });
    connect(m_stop, &QPushButton::clicked, this, [this] { m_bench.nesting().stop(); });
    connect(m_split, &LinkRow::clicked, this, &SheetsDock::splitTooLarge);
    return head;
}

QWidget *SheetsDock::makeFoot()
{
    auto *foot = new QWidget(this);
    m_foot = new QLabel(foot);
    m_foot->setObjectName(QStringLiteral("sheetsTotals"));
    m_foot->setTextFormat(Qt::RichText);
    auto *row = new QHBoxLayout(foot);
    row->setContentsMargins(12, 5, 12, 6);
    row->addWidget(m_foot, 1);
    m_unpin = new LinkRow(foot);
    m_unpin->setObjectName(QStringLiteral("sheetsUnpin"));
    m_unpin->setTexts({tr("Unpin all")});
    row->addWidget(m_unpin);
    auto *offcut = new LinkRow(foot);
    offcut->setObjectName(QStringLiteral("sheetsOffcut"));
    offcut->setTexts({tr("Add an offcut")});
    row->addWidget(offcut);
    connect(offcut, &LinkRow::clicked, this,
            [this] { Q_EMIT offcutWanted(m_layoutRows->stock()); });
    // Sheets stay where they are as it comes.
    foot->setMinimumHeight(m_unpin->sizeHint().height() + row->contentsMargins().top() +
                           row->contentsMargins().bottom());
    connect(m_unpin, &LinkRow::clicked, this,
            [this] { m_bench.run(QStringLiteral("sheets.unpinAll")); });
    return foot;
}

QString SheetsDock::note() const
{
    if (m_bench.session().model().sectionCount() == 0)
        return tr("Draw a section and it will lie here, ready to cut.");
    if (const auto why = m_work->whyNot())
        return io::errorSentence(*why);
    return m_work->cutting() ? QString() : tr("Nesting…");
}

void SheetsDock::refresh()
{
    if (!isVisible())
        return;
    const bool isOlder = m_work->isWorking();
    const QString said = note();
    const void *shown = m_work->made().get();
    if (shown != m_shown || isOlder != m_wasOlder || said != m_view->content().note) {
        SheetsContent content = said.isEmpty() ? sheetsContent(m_work->made()) : SheetsContent();
        content.isOlder = isOlder;
        content.note = said;
        if (shown != m_shown)
            m_said.clear();
        m_shown = shown;
        m_wasOlder = isOlder;
        m_view->setContent(std::move(content));
    }
    m_layoutRows->refresh();
    refreshHead();
    refreshTooLarge();
    refreshFoot();
}

void SheetsDock::refreshHead()
{
    const SheetNesting &nesting = m_bench.nesting();
    const bool isSearching = nesting.isSearching();
    m_level->setCurrent(static_cast<int>(nesting.level()));
    const double filled = m_work->made() ? m_work->made()->nested->filled : 0.0;
    m_bar->setVisible(isSearching);
    m_stop->setVisible(isSearching);
    // What has come of it, not the time: how far Best comes nobody knows. That it goes on the
    // seconds tell.
    m_bar->setValue(static_cast<int>(std::lround(kThousand * filled)));
    //: %1 is how much of the sheets is filled
    m_bar->setFormat(tr("Nesting… %1 % used").arg(locale().toString(100.0 * filled, 'f', 1)));
    if (isSearching)
        //: %1 are seconds
        m_state->setText(tr("keeps the best so far, %1 s").arg(std::floor(nesting.searchedFor())));
    else if (m_wasOlder && m_view->content().note.isEmpty() && !m_view->hand())
        m_state->setText(tr("Nesting again…"));
    else
        m_state->setText(m_said.isEmpty() ? looseText() : m_said);
}

/// Of pinned parts that could not stay.
QString SheetsDock::looseText() const
{
    const bool isThere = m_work->made() && m_view->content().note.isEmpty();
    const auto count = isThere ? m_work->made()->nested->loosened.size() : 0;
    return count == 0 ? QString()
                      : tr("%n pinned part(s) had no room where they were.", nullptr,
                           static_cast<int>(count));
}

void SheetsDock::edit(SectionEdit edit)
{
    m_said.clear();
    m_bench.editSections(std::move(edit));
}

void SheetsDock::say(const QString &why)
{
    m_said = why;
    refreshHead();
    Q_EMIT said(why); // where the eyes of the hand are not far
}

void SheetsDock::refreshTooLarge()
{
    const std::vector<SectionRef> sections = tooLargeOn(m_view->content());
    m_tooLarge->setVisible(!sections.empty());
    if (sections.empty())
        return;
    const Model &model = m_work->made()->analysis->model;
    const Stock &stock = model.stockOf(static_cast<std::size_t>(model.indexOf(sections.front())));
    const QString noRoom =
        noRoomText(stock, m_work->made()->nested->question->nesting.layout.margin);
    // Of a sheet without room a grid makes crumbs.
    m_split->setVisible(noRoom.isEmpty());
    if (!noRoom.isEmpty()) {
        m_tooLargeText->setText(noRoom);
        return;
    }
    const QString name = QString::fromStdString(model.nameOf(sections.front()));
    m_tooLargeText->setText(sections.size() == 1
                                //: %1 is the name of a section
                                ? tr("%1 is too large for its sheet.").arg(name)
                                //: %1 is the name of a section
                                : tr("%1 and %n more are too large for their sheets.", nullptr,
                                     static_cast<int>(sections.size()) - 1)
                                      .arg(name));
}

/// One after the other: a grid is of one section.
void SheetsDock::splitTooLarge()
{
    const std::vector<SectionRef> sections = tooLargeOn(m_view->content());
    if (sections.empty())
        return;
    m_bench.select({sections.front()});
    m_bench.run(QStringLiteral("operation.grid"));
}

/// Where all sheets have one.
QString SheetsDock::priceText() const
{
    const Nested &nested = *m_work->made()->nested;
    double sum = 0.0;
    for (std::size_t i = 0; i < nested.layout->sheets.size(); ++i) {
        if (m_view->content().facts[i].isTooLarge || m_view->content().facts[i].isOffcut)
            continue; // offcuts are paid for
        const Stock *stock = nested.analysis->model.document.find(nested.layout->sheets[i].stock);
        if (!stock || !stock->price)
            return {};
        sum += *stock->price;
    }
    return sum > 0.0 ? locale().toCurrencyString(sum) : QString();
}

void SheetsDock::refreshFoot()
{
    m_unpin->setVisible(!m_bench.session().committed().document.pins.empty());
    const Cutting *cutting = m_view->content().note.isEmpty() ? m_work->cutting() : nullptr;
    if (!cutting) {
        m_foot->clear();
        return;
    }
    const Nested &nested = *m_work->made()->nested;
    const auto bold = [](const QString &text) { return QStringLiteral("<b>%1</b>").arg(text); };
    const int sheets = cutting->sheetCount() - static_cast<int>(nested.layout->oversized.size());
    const QString parts = bold(partCountText(cutting->partCount));
    const QString length = cutLengthText(nested.cutLength, locale());
    //: %1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine
    //: cuts
    QStringList facts{sheets > 0
                          ? tr("%1 on %2 \u00B7 %3 % used \u00B7 %4 of cutting")
                                .arg(parts, bold(sheetCountText(sheets)),
                                     locale().toString(100.0 * nested.filled, 'f', 1), length)
                          //: %1 are the parts, %2 is how far the machine cuts
                          : tr("%1 \u00B7 %2 of cutting").arg(parts, length)};
    // By the machine that Export writes for.
    if (const QString time = m_time.text(*m_work, rememberedChoices()); !time.isEmpty())
        facts += time;
    for (const MissingSheets &missing : cutting->missing)
        facts += tr("%n sheet(s) more than there are", nullptr, missing.count);
    if (const QString price = priceText(); !price.isEmpty())
        facts += price;
    m_foot->setText(keepingUnits(facts.join(QStringLiteral(" \u00B7 "))));
}

void SheetsDock::light(std::optional<SectionRef> section)
{
    m_lights = section.has_value();
    m_bench.setOutlined(section ? std::vector{*section} : std::vector<SectionRef>());
}

/// What is under the cursor in the view, or in a list, is lit here; not what is hovered here.
void SheetsDock::followView()
{
    if (m_lights || !isVisible())
        return;
    const Model &model = m_bench.session().model();
    const int hovered = m_bench.interaction().hovered().section;
    std::optional<SectionRef> lit;
    if (hovered >= 0 && static_cast<std::size_t>(hovered) < model.sectionCount())
        lit = model.ref(static_cast<std::size_t>(hovered));
    else if (!m_bench.outlined().empty())
        lit = m_bench.outlined().front();
    m_view->setLit(lit);
}

void SheetsDock::showEvent(QShowEvent *event)
{
    QDockWidget::showEvent(event);
    const ExportChoices choices = rememberedChoices();
    m_bench.nesting().setOptions(choices.nesting());
    m_work->setLook(choices.cuts());
    m_work->setWanted(true);
    m_view->setSelected(m_bench.interaction().selection());
    refresh();
}

void SheetsDock::hideEvent(QHideEvent *event)
{
    QDockWidget::hideEvent(event);
    if (m_lights)
        light(std::nullopt);
    m_work->setWanted(false);
}

void SheetsDock::refreshColours()
{
    m_shown = nullptr;
    refresh();
}

} // namespace fff::ui
