#include "ui/dialogs/export_dialog.h"

#include "core/session/check_list.h"
#include "core/session/sheet_nesting.h"
#include "ui/base/icon.h"
#include "ui/base/lengths.h"
#include "ui/base/rich_text.h"
#include "ui/base/theme.h"
#include "ui/bench/cutting_words.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/cutting_work.h"
#include "ui/dialogs/export_place.h"
#include "ui/dialogs/export_place_row.h"
#include "ui/dialogs/export_preview.h"
#include "ui/dialogs/export_questions.h"
#include "ui/dialogs/export_rows.h"
#include "ui/dialogs/remark_rows.h"
#include "ui/dialogs/stock_edits.h"
#include "ui/properties/open_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr QSize kUsualSize(1048, 700), kLeastSize(860, 560); // px
constexpr int kLeastChoices = 345;                           // px, width of the left column

QStringList keptFiles(const ExportChoices &choices)
{
    return QStringList(choices.file) + choices.files;
}

} // namespace

ExportDialog::ExportDialog(Workbench &bench, const CheckList &checks, std::vector<ExportFile> files,
                           ExportPlace &place, QWidget *parent)
    : QDialog(parent), m_bench(bench), m_checks(checks), m_place(place),
      m_choices(rememberedChoices())
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export cutting files"));
    const QSize there = screen()->availableSize() - QSize(24, 44); // for its frame
    setMinimumSize(kLeastSize.boundedTo(there));
    resize(kUsualSize.boundedTo(there));
    m_stocks = new StockEdits(bench, this);
    bench.nesting().setOptions(m_choices.nesting());
    m_work = new CuttingWork(bench.session(), bench.nesting(), this);
    m_work->setLook(m_choices.cuts());
    m_work->setWanted(true);

    auto *middle = new QHBoxLayout;
    middle->setContentsMargins(16, 14, 16, 12);
    middle->setSpacing(16);
    middle->addWidget(makeChoices(std::move(files)));
    auto *right = new QVBoxLayout;
    right->setSpacing(10);
    m_preview = new ExportPreview(*m_work, *m_stocks, m_choices, this);
    m_remarks = new RemarkRows(m_preview->lastInOrder(), this);
    right->addWidget(m_preview, 1);
    right->addWidget(m_remarks);
    middle->addLayout(right, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(middle, 1);
    column->addWidget(makeFoot());

    connect(m_questions, &ExportQuestions::fileChanged, this, &ExportDialog::takeFile);
    connect(&m_questions->place(), &ExportPlaceRow::changeWanted, this, &ExportDialog::changePlace);
    const auto takeLayout = [this] {
        m_bench.nesting().setOptions(m_choices.nesting());
        takeLook();
        m_preview->refresh(); // margin and bar at once
        refresh();            // what the machine takes
    };
    connect(m_rows, &ExportRows::layoutChanged, this, takeLayout);
    connect(m_rows, &ExportRows::couponWanted, this, &ExportDialog::couponWanted);
    connect(m_questions, &ExportQuestions::machineChanged, this, [this, takeLayout] {
        m_rows->refresh();
        takeLayout();
    });
    connect(m_work, &CuttingWork::changed, this, &ExportDialog::refresh);
    connect(&m_checks, &CheckList::changed, this, &ExportDialog::refresh);
    connect(m_remarks, &RemarkRows::showWanted, this,
            [this](int index) { showOf(m_remarks->remarks()[static_cast<std::size_t>(index)]); });
    connect(&settings(), &Settings::unitChanged, this, &ExportDialog::refresh);
    dress(this);
    takeFile();
}

/// What was only tried here is not how parts lie from now on.
ExportDialog::~ExportDialog()
{
    m_bench.nesting().setOptions(rememberedChoices().nesting());
}

QWidget *ExportDialog::makeChoices(std::vector<ExportFile> files)
{
    auto *area = new QScrollArea(this);
    area->setObjectName(QStringLiteral("exportChoices"));
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus); // its fields have it
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *all = new QWidget(area);
    auto *column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 12, 0);
    column->setSpacing(4);
    m_stocks->takeKerfsOf(m_choices.machine.toStdString());
    m_questions =
        new ExportQuestions(*m_stocks, m_choices, std::move(files), keptFiles(m_choices), all);
    m_rows = new ExportRows(*m_stocks, m_choices, all);
    column->addWidget(m_questions);
    column->addWidget(m_rows);
    column->addStretch(1);
    area->setWidget(all);
    // Nothing of it is cut off at the right, in any language.
    all->ensurePolished();
    const int bar = area->verticalScrollBar()->sizeHint().width();
    area->setFixedWidth(std::max({kLeastChoices, all->minimumSizeHint().width(),
                                  m_questions->leastWidth() + column->contentsMargins().right()}) +
                        bar);
    return area;
}

QWidget *ExportDialog::makeFoot()
{
    auto *foot = new QFrame(this);
    foot->setObjectName(QStringLiteral("exportFoot")); // a line above it, by the style sheet
    m_foot = new QLabel(foot);
    m_foot->setObjectName(QStringLiteral("exportTotals"));
    m_foot->setTextFormat(Qt::RichText);
    m_foot->setWordWrap(true); // in two lines where words are long
    m_opensFolder = new QCheckBox(tr("Open the folder afterwards"), foot);
    m_opensFolder->setObjectName(QStringLiteral("exportOpensFolder"));
    m_opensFolder->setChecked(m_choices.opensFolder);
    auto *cancel = new QPushButton(tr("Cancel"), foot);
    cancel->setObjectName(QStringLiteral("exportCancel"));
    m_export = new QPushButton(foot);
    m_export->setObjectName(QStringLiteral("exportNow"));
    m_export->setIconSize({18, 18});
    for (QPushButton *button : {cancel, m_export}) {
        button->setAutoDefault(false); // Enter in a field is for the field
        button->setMinimumHeight(28);
    }
    auto *row = new QHBoxLayout(foot);
    row->setContentsMargins(16, 10, 16, 12);
    row->setSpacing(12);
    row->addWidget(m_foot, 1);
    row->addWidget(m_opensFolder);
    row->addWidget(cancel);
    row->addWidget(m_export);
    connect(m_opensFolder, &QCheckBox::clicked, this,
            [this](bool on) { m_choices.opensFolder = on; });
    connect(cancel, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::goOn);
    return foot;
}

void ExportDialog::tellOfCoupon(const QString &sentence)
{
    m_rows->tellOfCoupon(sentence);
    auto *area = findChild<QScrollArea *>(QStringLiteral("exportChoices"));
    area->widget()->layout()->activate();
    area->ensureWidgetVisible(findChild<QLabel *>(QStringLiteral("exportCouponSaid")));
}

/// As the file will have it.
void ExportDialog::takeLook()
{
    m_work->setLook(m_choices.cuts(), file().isColoured && m_choices.hasJointColours);
}

void ExportDialog::takeFile()
{
    m_choices.file = file().key;
    m_choices.files = m_questions->chosenFiles();
    m_rows->setFile(file());
    takeLook();
    m_preview->setFile(file());
    refresh();
}

void ExportDialog::showPlace()
{
    const Cutting *cutting = m_work->cutting();
    const bool areSeveral = file().isFilePerSheet && (!cutting || cutting->sheetCount() > 1);
    m_questions->place().setPath(m_place.pathOf(file()), areSeveral);
}

void ExportDialog::changePlace()
{
    if (!m_place.change(this, file()))
        return;
    showPlace();
    m_export->setFocus(Qt::OtherFocusReason); // what is left to do
}

const ExportFile &ExportDialog::file() const
{
    return m_questions->file();
}

void ExportDialog::refresh()
{
    const bool isForMachine = file().isFolder || file().use == io::FileUse::Cutting;
    m_remarks->setRemarks(
        exportRemarks(m_checks, *m_work, isForMachine ? m_choices.chosenMachine().get() : nullptr));
    m_questions->setLayout(m_work->made() ? m_work->made()->nested->layout : nullptr);
    showPlace();
    refreshFoot();
    takeLeastWidth();
}

/// The foot is never cut off, however long its words are.
void ExportDialog::takeLeastWidth()
{
    m_foot->parentWidget()->layout()->invalidate();
    layout()->invalidate();
    setMinimumWidth(std::max(minimumWidth(), layout()->minimumSize().width()));
}

/// How long it takes, and that parts may come to lie better, or otherwise, than they do.
QString ExportDialog::afterIt()
{
    const bool isNesting = m_bench.nesting().isSearching() || m_work->isWorking();
    QString text;
    for (const QString &one :
         {m_time.text(*m_work, m_choices), isNesting ? tr("Nesting…") : QString()})
        if (!one.isEmpty())
            text += QStringLiteral(" \u00B7 ") + one;
    return text;
}

void ExportDialog::refreshFoot()
{
    const Cutting *cutting = m_work->cutting();
    const auto bold = [](const QString &text) { return QStringLiteral("<b>%1</b>").arg(text); };
    if (cutting && file().isSkin)
        //: %1 are the sections of the model
        m_foot->setText(tr("Skin over %1")
                            .arg(bold(sectionCountText(
                                static_cast<int>(m_bench.session().model().sectionCount())))));
    else if (cutting && file().isSolids)
        //: %1 are the sections of the model
        m_foot->setText(tr("%1 as solids")
                            .arg(bold(sectionCountText(
                                static_cast<int>(m_bench.session().model().sectionCount())))));
    else if (cutting)
        //: %1 are the parts, %2 the sheets, %3 is how far the machine cuts
        m_foot->setText(
            keepingUnits(tr("%1 on %2 \u00B7 %3 of cutting")
                             .arg(bold(partCountText(cutting->partCount)),
                                  bold(sheetCountText(cutting->sheetCount())),
                                  cutLengthText(cutLength(cutting->drawing), locale())) +
                         afterIt()));
    else
        m_foot->setText(m_work->isWorking() ? tr("Working…") : QString());
    const std::vector<ExportRemark> &remarks = m_remarks->remarks();
    const bool isWrong = std::any_of(remarks.begin(), remarks.end(), [](const ExportRemark &r) {
        return r.severity == Severity::Error;
    });
    m_export->setText(isWrong ? tr("Export anyway") : tr("Export"));
    const std::optional<Error> whyNot = m_work->whyNot();
    // Why is among the remarks.
    m_export->setEnabled(!whyNot || (file().isSolids && m_work->made()));
    const auto mask = [this](const QColor &colour) {
        return tintedPixmap(QStringLiteral("export"), 18, colour, devicePixelRatioF());
    };
    QIcon icon(mask(theme().onAccent));
    icon.addPixmap(mask(theme().muted), QIcon::Disabled);
    m_export->setIcon(icon);
}

/// Closes, and keeps what was changed: whoever looks at a problem goes on from there.
void ExportDialog::showOf(const ExportRemark &remark)
{
    m_problem = remark.finding;
    m_sections = remark.sections;
    rememberChoices(m_choices);
    QDialog::reject();
}

void ExportDialog::goOn()
{
    commitOpenEditor();
    if (!m_place.mayWrite(this, file()))
        return;
    rememberChoices(m_choices);
    accept();
}

void ExportDialog::reject()
{
    m_stocks->takeBack();
    QDialog::reject();
}

void ExportDialog::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    // On a switch it goes on as well: there Space is what switches.
    if (isEnter && qobject_cast<QCheckBox *>(focusWidget()))
        m_export->click();
    else if (auto *button = qobject_cast<QAbstractButton *>(focusWidget()); isEnter && button)
        button->click();
    else if (event->key() == Qt::Key_PageUp || event->key() == Qt::Key_PageDown)
        m_preview->turnBy(event->key() == Qt::Key_PageUp ? -1 : 1);
    else
        QDialog::keyPressEvent(event);
}

/// Whoever has nothing to change presses Enter.
void ExportDialog::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    takeLeastWidth(); // its style, and so its fonts, are there by now
    m_export->setFocus(Qt::OtherFocusReason);
}

} // namespace fff::ui
