#include "ui/start/start_page.h"

#include "ui/base/ago_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/cards/card_grid.h"
#include "ui/cards/model_card.h"
#include "ui/settings/settings.h"
#include "ui/start/samples.h"
#include "ui/view/heading_weight.h"

#include <QCheckBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace fff::ui {

namespace {

constexpr int kLeftWidth = 260, kMargin = 24, kGap = 16; // px
constexpr int kBesideCards = 14; // px: six columns in the usual window, also beside a scroll bar
constexpr int kHeadingSize = 20; // px, UI.md section 4
constexpr int kRowIcon = 20;     // px

void clear(QVBoxLayout *rows)
{
    while (QLayoutItem *item = rows->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
}

QPushButton *makeButton(const QString &text, const char *name)
{
    auto *button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    return button;
}

} // namespace

StartPage::StartPage(QWidget *parent)
    : QWidget(parent), m_thumbnails({ModelCard::kWidth, ModelCard::kPictureHeight})
{
    setObjectName(QStringLiteral("startPage"));
    setAccessibleName(tr("Start page"));
    setFocusPolicy(Qt::StrongFocus);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(makeLeft());
    row->addWidget(makeMiddle(), 1);
    connect(&settings(), &Settings::recentFilesChanged, this, &StartPage::fillRecent,
            Qt::QueuedConnection); // a card may be what changes them
    connect(&m_thumbnails, &Thumbnails::ready, this, &StartPage::showPicture);
    fillRecent();
    fillSamples();
    dress(this);
}

QWidget *StartPage::makeLeft()
{
    auto *left = new QWidget(this);
    left->setFixedWidth(kLeftWidth);
    auto *begin = m_new = new QPushButton(tr("New"), left);
    begin->setObjectName(QStringLiteral("startNew"));
    begin->setToolTip(tr("Draw a model of your own"));
    begin->setMinimumHeight(56);
    begin->setIconSize({24, 24});
    QFont font = begin->font();
    font.setPixelSize(kHeadingSize - 4);
    font.setWeight(headingWeight());
    begin->setFont(font);
    setFocusProxy(begin);
    auto *tour = new QPushButton(tr("Your first model in 3 minutes"), left);
    tour->setObjectName(QStringLiteral("startTour"));
    tour->setToolTip(tr("Draw, check and cut a model, one step at a time"));
    tour->setMinimumHeight(36);
    auto *open = new QPushButton(themedIcon(QStringLiteral("open")), tr("Open…"), left);
    open->setObjectName(QStringLiteral("startOpen"));
    open->setToolTip(tr("Open a model, also from FlatFab"));
    open->setMinimumHeight(36);
    auto *note = new QLabel(tr("No account, nothing leaves this computer."), left);
    note->setWordWrap(true);
    note->setForegroundRole(QPalette::PlaceholderText);
    auto *atStart = new QCheckBox(tr("Show at startup"), left);
    atStart->setObjectName(QStringLiteral("startShows"));
    atStart->setChecked(settings().showsStartPage());
    connect(begin, &QPushButton::clicked, this, &StartPage::newWanted);
    connect(tour, &QPushButton::clicked, this, &StartPage::tourWanted);
    connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
    connect(atStart, &QCheckBox::toggled, this,
            [](bool shows) { settings().setShowsStartPage(shows); });
    connect(&settings(), &Settings::startPageChanged, atStart,
            [atStart] { atStart->setChecked(settings().showsStartPage()); });

    auto *column = new QVBoxLayout(left);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->setSpacing(12);
    column->addWidget(makeHeading(QStringLiteral("FlatFitFab")));
    column->addWidget(begin);
    column->addWidget(tour);
    column->addWidget(open);
    column->addSpacing(4);
    column->addWidget(note);
    column->addStretch();
    column->addWidget(atStart);
    return left;
}

QWidget *StartPage::makeMiddle()
{
    auto *page = new QWidget;
    m_unreadable = new QVBoxLayout;
    m_unreadable->setSpacing(8);
    m_recovered = new QVBoxLayout;
    m_recovered->setSpacing(8);
    m_recentHeading = makeHeading(tr("Recent"));
    const QSize card(ModelCard::kWidth, ModelCard::kHeight);
    m_recent = new CardGrid(card, kGap, page);
    m_recent->setObjectName(QStringLiteral("startRecent"));
    m_recent->setLeastWidth(ModelCard::kWidth);
    m_recent->setMostRows(1);
    m_samples = new CardGrid(card, kGap, page);
    m_samples->setObjectName(QStringLiteral("startSamples"));
    m_samples->setLeastWidth(ModelCard::kWidth);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(kBesideCards, kMargin, kBesideCards, kMargin);
    column->setSpacing(12);
    column->addLayout(m_unreadable);
    column->addLayout(m_recovered);
    column->addWidget(m_recentHeading);
    column->addWidget(m_recent);
    column->addSpacing(12);
    column->addWidget(makeHeading(tr("Samples")));
    column->addWidget(m_samples);
    column->addStretch();

    auto *scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(page);
    scroll->viewport()->setAutoFillBackground(false);
    page->setAutoFillBackground(false);
    return scroll;
}

QLabel *StartPage::makeHeading(const QString &text)
{
    auto *heading = new QLabel(text, this);
    QFont font = heading->font();
    font.setPixelSize(kHeadingSize);
    font.setWeight(headingWeight());
    heading->setFont(font);
    return heading;
}

/// What a person should know or may go on with, and what can be done about it.
QFrame *StartPage::addRow(QVBoxLayout *rows, const QPixmap &icon, const QString &text,
                          std::initializer_list<QPushButton *> buttons)
{
    auto *row = new QFrame(this);
    auto *picture = new QLabel(row);
    picture->setPixmap(icon);
    auto *words = new QLabel(text, row);
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    auto *line = new QHBoxLayout(row);
    line->setContentsMargins(12, 8, 8, 8);
    line->setSpacing(12);
    line->addWidget(picture);
    line->addWidget(words, 1);
    for (QPushButton *button : buttons)
        line->addWidget(button);
    rows->addWidget(row);
    return row;
}

void StartPage::setRecovered(const std::vector<RecoveredWork> &works)
{
    clear(m_recovered);
    const QPixmap icon =
        tintedPixmap(QStringLiteral("clock"), kRowIcon, theme().accent, devicePixelRatioF());
    for (const RecoveredWork &work : works) {
        QPushButton *open = makeButton(tr("Open it"), "recoverOpen");
        QPushButton *discard = makeButton(tr("Discard"), "recoverDiscard");
        const QString id = work.id;
        connect(open, &QPushButton::clicked, this, [this, id] { Q_EMIT recoverWanted(id); });
        connect(discard, &QPushButton::clicked, this, [this, id] { Q_EMIT discardWanted(id); });
        //: %1 is a model's name, how much was done, and when
        auto *row = addRow(m_recovered, icon, tr("Recovered: %1").arg(work.text), {open, discard});
        row->setObjectName(QStringLiteral("recoveredRow"));
        row->setProperty("recovered", true);
        dress(row);
    }
}

void StartPage::setUnreadable(const std::vector<UnreadableCopy> &copies)
{
    clear(m_unreadable);
    const QPixmap icon =
        tintedPixmap(QStringLiteral("warn"), kRowIcon, theme().warning, devicePixelRatioF());
    for (const UnreadableCopy &copy : copies) {
        QPushButton *show = makeButton(tr("Show the folder"), "unreadableShow");
        QPushButton *note = makeButton(tr("OK"), "unreadableNote");
        const QString path = copy.path;
        connect(show, &QPushButton::clicked, this, [this, path] { Q_EMIT folderWanted(path); });
        connect(note, &QPushButton::clicked, this, [this, path] { Q_EMIT noteTaken(path); });
        auto *row = addRow(m_unreadable, icon, copy.text, {show, note});
        row->setObjectName(QStringLiteral("unreadableRow"));
        row->setToolTip(copy.why);
        dress(row);
    }
}

void StartPage::fillRecent()
{
    m_shownRecent.clear();
    std::vector<QWidget *> cards;
    const QDateTime now = QDateTime::currentDateTime();
    for (const QString &path : settings().recentFiles()) {
        const QFileInfo info(path);
        auto *card = new ModelCard(info.completeBaseName());
        card->setObjectName(QStringLiteral("recentCard"));
        card->setToolTip(QDir::toNativeSeparators(path));
        QString note = tr("missing");
        const QDateTime opened = settings().recentTime(path);
        if (!info.exists())
            card->setMissing();
        else if (opened.isValid())
            note = agoText(opened, now, locale());
        else // a list of before there were times
            note.clear();
        card->setNote(note);
        const auto remove = [path] { settings().removeRecentFile(path); };
        connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileChosen(path); });
        connect(card, &ModelCard::removalWanted, this, remove);
        card->setContextMenuPolicy(Qt::ActionsContextMenu);
        auto *forget =
            new QAction(themedIcon(QStringLiteral("close")), tr("Remove from this list"), card);
        connect(forget, &QAction::triggered, this, remove);
        card->addAction(forget);
        m_shownRecent.push_back({path, card, note});
        cards.push_back(card);
    }
    m_recent->setCards(cards);
    m_recentHeading->setVisible(!cards.empty());
    m_recent->setVisible(!cards.empty());
    if (isVisible())
        requestPictures();
}

void StartPage::fillSamples()
{
    m_shownSamples.clear();
    std::vector<QWidget *> cards;
    for (const Sample &sample : samples()) {
        auto *card = new ModelCard(sample.name);
        card->setObjectName(QStringLiteral("sampleCard"));
        card->setToolTip(tr("Open a copy of it"));
        const QString path = sample.path;
        connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT sampleChosen(path); });
        m_shownSamples.push_back({path, card, {}});
        cards.push_back(card);
    }
    m_samples->setCards(cards);
}

void StartPage::refreshColours()
{
    m_shownStyle = theme().viewStyle();
    m_new->setIcon(tintedPixmap(QStringLiteral("new"), 24, theme().onAccent, devicePixelRatioF()));
    requestPictures();
}

void StartPage::requestPictures()
{
    m_thumbnails.clear();
    for (const auto &list : {m_shownRecent, m_shownSamples}) {
        for (const Shown &shown : list) {
            if (QFileInfo::exists(shown.path))
                m_thumbnails.request(shown.path, devicePixelRatioF());
        }
    }
}

void StartPage::showPicture(const QString &path, const QImage &picture, int sectionCount)
{
    const QString count = tr("%n section(s)", nullptr, sectionCount);
    for (const auto *list : {&m_shownRecent, &m_shownSamples}) {
        for (const Shown &shown : *list) {
            if (shown.path != path)
                continue;
            shown.card->setPicture(picture);
            shown.card->setNote(shown.note.isEmpty()
                                    ? count
                                    //: %1 is a number of sections, %2 when it was opened last
                                    : tr("%1, %2").arg(count, shown.note));
        }
    }
}

void StartPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refreshColours();
}

void StartPage::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    const bool isOfColours =
        event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange;
    if (isOfColours && isVisible() && !(m_shownStyle == theme().viewStyle()))
        refreshColours();
}

void StartPage::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().alternate);
    painter.fillRect(QRect(0, 0, kLeftWidth, height()), theme().window);
    painter.fillRect(QRect(kLeftWidth - 1, 0, 1, height()), theme().border);
}

} // namespace fff::ui
