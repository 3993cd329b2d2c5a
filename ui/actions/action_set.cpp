#include "ui/actions/action_set.h"

#include "core/session/message_text.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "ui/actions/menu_keys.h"
#include "ui/actions/menu_table.h"
#include "ui/base/icon.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace fff::ui {

namespace {

constexpr char kSentence[] = "sentence";         // of the tooltip, without the shortcut
constexpr char kOwnKeys[] = "ownKeys";           // as the program has them
constexpr char kEnglishTitle[] = "englishTitle"; // of a menu

bool isSearchedMenu(const MenuRow &row)
{
    return row.key && QLatin1String(row.key) == QLatin1String(kSearchedMenu);
}

QStringList words(const char *text)
{
    return QString::fromLatin1(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// As words of commands name it.
QString nameOf(const MenuRow &row)
{
    return row.key ? QLatin1String(row.key) : QString::fromLatin1(row.title).remove(u'&');
}

/// And what opens beside it with nothing in it.
void dropDisabled(QMenu *menu)
{
    for (QAction *action : menu->actions()) {
        if (action->menu())
            dropDisabled(action->menu());
        const bool isEmpty = action->menu() && action->menu()->isEmpty();
        if (!action->isSeparator() && (isEmpty || (!action->menu() && !action->isEnabled())))
            menu->removeAction(action);
    }
}

} // namespace

ActionSet::ActionSet(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    for (const CommandWords *words : bench.commands().offered()) {
        auto *action = new QAction(messageText(words->text), this);
        action->setObjectName(QLatin1String(words->id));
        action->setIconText(messageText(words->shortText));
        action->setIcon(themedIcon(QLatin1String(words->icon)));
        // Also while the tooltip says why it cannot be done.
        action->setWhatsThis(messageText(words->tip));
        action->setProperty(kOwnKeys, QLatin1String(words->shortcuts));
        if (words->isForView)
            action->setShortcutContext(Qt::WidgetShortcut);
        const QString id = action->objectName();
        connect(action, &QAction::triggered, this, [this, id] { Q_EMIT triggered(id); });
        m_actions.insert(id, {action, words, messageText(words->text)});
        setTip(action, action->whatsThis());
    }

    connect(&settings(), &Settings::shortcutsChanged, this, &ActionSet::applyShortcuts);
    connect(&settings(), &Settings::drawingChanged, this, &ActionSet::refresh);
    connect(&bench, &Workbench::selectionChanged, this, &ActionSet::refresh);
    connect(&bench, &Workbench::viewStateChanged, this, &ActionSet::refresh);
    connect(&bench.session(), &Session::modelChanged, this, [this] {
        if (!m_bench.session().hasPreview()) // in a drag nothing else can be done
            refresh();
    });
    connect(bench.session().history(), &QUndoStack::indexChanged, this, &ActionSet::refresh);
    connect(&bench.session().scheduler(), &Scheduler::asked, this, &ActionSet::refresh);
    applyShortcuts();
    refresh();
}

/// With what the window has put into them, whose keys come first. An entry that stands in two menus
/// keeps what the first one gave it.
void ActionSet::giveKeys(const QList<QAction *> &menu)
{
    QStringList texts, sources;
    for (const QAction *action : menu) {
        const auto entry = m_actions.constFind(action->objectName());
        texts += action->text();
        sources += entry != m_actions.cend() ? QString::fromUtf8(entry->words->text.source)
                                             : action->property(kEnglishTitle).toString();
    }
    const QStringList marked = withMenuKeys(texts, sources);
    for (qsizetype i = 0; i < menu.size(); ++i) {
        menu[i]->setText(marked[i]);
        if (const auto entry = m_actions.find(menu[i]->objectName()); entry != m_actions.end())
            entry->text = marked[i];
        if (menu[i]->menu())
            giveKeys(menu[i]->menu()->actions());
    }
}

QMenu *ActionSet::named(QMenu *menu, const MenuRow &row)
{
    menu->menuAction()->setProperty(kEnglishTitle, QLatin1String(row.title));
    return menu;
}

QAction *ActionSet::action(const char *id) const
{
    return m_actions.value(QLatin1String(id)).action; // null for what the window has not
}

void ActionSet::fill(QMenu *menu, std::initializer_list<const char *> ids) const
{
    for (const char *id : ids) {
        if (*id)
            menu->addAction(action(id));
        else
            menu->addSeparator();
    }
}

void ActionSet::fill(QToolBar *bar, std::initializer_list<const char *> ids) const
{
    for (const char *id : ids) {
        if (*id)
            bar->addAction(action(id));
        else
            bar->addSeparator();
    }
}

void ActionSet::fill(QMenuBar *bar, const std::function<void(const QString &, QMenu *)> &own)
{
    m_window = bar->window();
    QList<QAction *> seen;
    for (const MenuRow &row : menuTable()) {
        const bool isSearched = isSearchedMenu(row);
        if (row.key && !isSearched)
            continue;
        QMenu *menu = named(bar->addMenu(tr(row.title)), row);
        fill(menu, row, own);
        if (!isSearched) {
            seen += menu->menuAction();
            continue;
        }
        menu->menuAction()->setVisible(false);
        bar->window()->addActions(menu->actions()); // keys of a hidden menu's are dead
    }
    giveKeys(seen);
}

void ActionSet::fill(QMenu *menu, const MenuRow &row,
                     const std::function<void(const QString &, QMenu *)> &own) const
{
    menu->setToolTipsVisible(true); // greyed entries say why
    for (const QString &id : words(row.ids)) {
        if (id == QStringLiteral("|"))
            menu->addSeparator();
        else if (id.startsWith(u'@') && own)
            own(id, menu);
        else if (m_actions.contains(id))
            menu->addAction(m_actions.value(id).action);
        else
            for (const MenuRow &beside : menuTable())
                if (beside.key && id.mid(1) == QLatin1String(beside.key))
                    fill(named(menu->addMenu(tr(beside.title)), beside), beside, own);
    }
    for (const CommandWords *words : m_bench.commands().offered())
        if (nameOf(row) == QLatin1String(words->menu))
            menu->addAction(action(words->id));
}

void ActionSet::fill(QMenu *menu, const char *key,
                     const std::function<void(const QString &, QMenu *)> &own)
{
    refresh();
    for (const MenuRow &row : menuTable())
        if (row.key && QLatin1String(key) == QLatin1String(row.key))
            fill(menu, row, own);
    dropDisabled(menu);
}

void ActionSet::addViewShortcuts(QWidget *view)
{
    m_view = view;
    for (const Entry &entry : m_actions)
        if (entry.words->isForView)
            view->addAction(entry.action);
}

bool ActionSet::isOfCommand(const QAction *action)
{
    return action->property(kOwnKeys).isValid();
}

QList<QKeySequence> ActionSet::ownShortcuts(const QAction *action)
{
    QList<QKeySequence> shortcuts;
    for (const QString &keys :
         action->property(kOwnKeys).toString().split(u' ', Qt::SkipEmptyParts))
        shortcuts += QKeySequence(keys, QKeySequence::PortableText);
    return shortcuts;
}

void ActionSet::applyShortcuts()
{
    for (const Entry &entry : qAsConst(m_actions)) {
        QAction *action = entry.action;
        const QList<QKeySequence> keys =
            settings().shortcuts(action->objectName()).value_or(ownShortcuts(action));
        if (action->shortcuts() != keys)
            action->setShortcuts(keys);
        if (entry.answer)
            entry.answer->setShortcuts(keys);
        setTip(action, sentence(action));
    }
}

void ActionSet::setTip(QAction *action, const QString &sentence)
{
    action->setProperty(kSentence, sentence);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? sentence : QStringLiteral("%1 (%2)").arg(sentence, keys));
}

QString ActionSet::sentence(const QAction *action)
{
    return action->property(kSentence).toString();
}

void ActionSet::refresh()
{
    for (Entry &entry : m_actions)
        show(entry);
}

/// Keys of an action that is not seen are dead: another one hears them, and says why.
void ActionSet::showAnswer(Entry &entry, bool answers)
{
    QWidget *where = entry.words->isForView ? m_view : m_window;
    if (answers && !entry.answer && where) {
        entry.answer = new QAction(this);
        entry.answer->setShortcutContext(entry.action->shortcutContext());
        entry.answer->setShortcuts(entry.action->shortcuts());
        where->addAction(entry.answer);
        connect(entry.answer, &QAction::triggered, this, [this, id = std::string(entry.words->id)] {
            if (const WhyNot whyNot = m_bench.commands().whyNot(id))
                Q_EMIT refused(messageText(*whyNot));
        });
    }
    if (entry.answer)
        entry.answer->setEnabled(answers);
}

void ActionSet::show(Entry &entry)
{
    const CommandRegistry &commands = m_bench.commands();
    const std::string id = entry.words->id;
    QAction *action = entry.action;
    const WhyNot whyNot = commands.whyNot(id);
    action->setEnabled(!whyNot);
    const bool isShown = commands.isShown(id);
    action->setVisible(isShown);
    showAnswer(entry, !isShown);
    const std::optional<bool> isOn = commands.isOn(id);
    action->setCheckable(isOn.has_value());
    action->setChecked(isOn.value_or(false));
    const Message does = whyNot ? Message() : commands.does(id);
    if (!does.isEmpty()) {
        const QString text = messageText(does);
        action->setText(text);
        setTip(action, QString(text).remove(u'&'));
        return;
    }
    action->setText(entry.text);
    setTip(action, messageText(whyNot ? *whyNot : entry.words->tip));
}

} // namespace fff::ui
