#include "core/session/session.h"

#include "core/analysis/analysed.h"
#include "core/analysis/pulling.h"
#include "core/operations/evaluate.h"
#include "core/session/journal.h"
#include "core/session/kept_models.h"
#include "core/session/scheduler.h"

#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QUndoCommand>

namespace fff {

class Session::Private
{
public:
    Private(Session *session, std::vector<Stage> stages);

    void show(ModelPointer next);
    void indexChanged();
    /// After so many steps. Null when there are not so many.
    KeptModelPointer keptAfter(int steps) const;

    Session *q;
    QUndoStack *stack;
    KeptModels models;
    ModelPointer committed = std::make_shared<const Model>(evaluate(newDocument()));
    KeptModelPointer at = models.keep(committed); // where the stack stands: what is committed, once
                                                  // it has arrived
    ModelPointer shown = committed;               // what was announced last
    std::uint64_t revision = 0;
    bool isResetting = false; // the stack's own signals say nothing then

    AnalysisPointer analysis; // the newest one
    Scheduler scheduler;
};

namespace {

/// The one undo command: says which model it is. Silent; the session has it made, where it is not
/// there any more, and announces it when the stack has arrived at its new index, once for a jump
/// over many.
class ModelStep : public QUndoCommand
{
public:
    ModelStep(const QString &text, KeptModelPointer *at, KeptModelPointer before,
              KeptModelPointer after, std::string merges)
        : QUndoCommand(text), m_at(at), m_before(std::move(before)), m_after(std::move(after)),
          m_merges(std::move(merges))
    {
    }
    int id() const override { return m_merges.empty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand *next) override
    {
        const auto *step = static_cast<const ModelStep *>(next);
        if (step->m_merges != m_merges)
            return false;
        m_after = step->m_after;
        return true;
    }
    void undo() override { *m_at = m_before; }
    void redo() override { *m_at = m_after; }
    const KeptModelPointer &before() const { return m_before; }
    const KeptModelPointer &after() const { return m_after; }

private:
    KeptModelPointer *m_at;
    KeptModelPointer m_before, m_after;
    std::string m_merges;
};

} // namespace

Session::Private::Private(Session *session, std::vector<Stage> stages)
    : q(session), stack(new QUndoStack(session)), scheduler(std::move(stages))
{
    scheduler.want(kAnalysed.name);
    scheduler.want(kPulled.name);
    QObject::connect(&scheduler, &Scheduler::published, q, [this](std::string_view stage) {
        const auto newest = scheduler.result(kAnalysed);
        if (stage != kAnalysed.name || !newest || analysis == newest->analysis)
            return;
        analysis = newest->analysis;
        Q_EMIT q->analysisChanged();
    });
    // Nothing follows from an empty model, so its analysis is known.
    auto empty = std::make_shared<Analysis>();
    empty->model = *committed;
    analysis = std::move(empty);
}

void Session::Private::show(ModelPointer next)
{
    if (next == shown) {
        scheduler.request(revision, shown, shown != committed); // it may be no preview any more
        return;
    }
    const ModelPointer before = std::exchange(shown, std::move(next));
    const ModelPointer after = shown; // kept, whatever a listener does
    ++revision;
    scheduler.request(revision, after, after != committed);
    Q_EMIT q->modelChanged(*before, *after);
}

void Session::Private::indexChanged()
{
    if (isResetting)
        return;
    committed = models.get(*at, *committed);
    qCDebug(journal, "step %s", digestOf(committed->document).constData());
    show(committed);
    Q_EMIT q->committedChanged();
}

KeptModelPointer Session::Private::keptAfter(int steps) const
{
    const auto step = [this](int index) {
        return static_cast<const ModelStep *>(stack->command(index));
    };
    if (steps < 0 || steps > stack->count())
        return nullptr;
    if (stack->count() == 0)
        return at;
    return steps == 0 ? step(0)->before() : step(steps - 1)->after();
}

Session::Session(QObject *parent) : Session(stages(), parent) {}

Session::Session(std::vector<Stage> stages, QObject *parent)
    : QObject(parent), d(std::make_unique<Private>(this, std::move(stages)))
{
    connect(d->stack, &QUndoStack::indexChanged, this, [this] { d->indexChanged(); });
    connect(d->stack, &QUndoStack::cleanChanged, this, &Session::cleanChanged);
}

Session::~Session()
{
    // The stack is a child and would outlive `d`; its last signals must not reach it.
    d->stack->disconnect(this);
}

const Model &Session::model() const
{
    return *d->shown;
}

const Model &Session::committed() const
{
    return *d->committed;
}

bool Session::hasPreview() const
{
    return d->shown != d->committed;
}

void Session::reset(Document document)
{
    Q_EMIT replaced();
    d->scheduler.forget();
    d->isResetting = true;
    d->committed = std::make_shared<const Model>(evaluate(std::move(document)));
    d->models.clear();
    d->at = d->models.keep(d->committed);
    d->stack->clear();
    d->stack->setClean(); // an empty history is not cleared, and may be of an unsaved document
    d->isResetting = false;
    qCDebug(journal, "opened %s", digestOf(d->committed->document).constData());
    d->show(d->committed);
    Q_EMIT committedChanged();
}

void Session::preview(Document document)
{
    if (document.isSame(d->shown->document))
        return;
    if (document.isSame(d->committed->document))
        d->show(d->committed);
    else
        d->show(std::make_shared<const Model>(evaluate(std::move(document), *d->committed)));
}

void Session::cancelPreview()
{
    d->show(d->committed);
}

void Session::commit(const QString &text, Document document, const std::string &merges)
{
    if (document.isSame(d->committed->document)) {
        cancelPreview();
        return;
    }
    // What is shown may be just this: then it stays, and nothing is announced or computed twice.
    const ModelPointer after =
        document.isSame(d->shown->document)
            ? d->shown
            : std::make_shared<const Model>(evaluate(std::move(document), *d->committed));
    d->stack->push(new ModelStep(text, &d->at, d->at, d->models.keep(after), merges));
}

QUndoStack *Session::history() const
{
    return d->stack;
}

std::shared_ptr<const Model> Session::modelAfter(int steps) const
{
    const KeptModelPointer kept = d->keptAfter(steps);
    return kept ? d->models.get(*kept, *d->committed) : nullptr;
}

bool Session::isClean() const
{
    return d->stack->isClean();
}

void Session::setClean()
{
    d->stack->setClean();
}

void Session::setSaved(const Document &document)
{
    QUndoStack &stack = *d->stack;
    if (document.isSame(d->committed->document)) {
        stack.setClean();
        return;
    }
    const int index = stack.index();
    int saved = stack.count();
    while (saved >= 0 && !document.isSame(d->keptAfter(saved)->document()))
        --saved;
    {
        // The stack marks only the step that it stands at.
        const QScopedValueRollback going(d->isResetting, true);
        const QSignalBlocker quiet(stack);
        if (saved >= 0) {
            stack.setIndex(saved);
            stack.setClean();
            stack.setIndex(index);
        } else {
            stack.resetClean();
        }
    }
    Q_EMIT stack.cleanChanged(stack.isClean());
}

void Session::setUnsaved()
{
    d->stack->resetClean();
}

std::uint64_t Session::revision() const
{
    return d->revision;
}

Scheduler &Session::scheduler() const
{
    return d->scheduler;
}

const Analysis &Session::analysis() const
{
    return *d->analysis;
}

const AnalysisPointer &Session::analysisPointer() const
{
    return d->analysis;
}

std::uint64_t Session::analysedRevision() const
{
    return d->scheduler.revisionOf(kAnalysed.name);
}

const Analysis &Session::currentAnalysis()
{
    d->scheduler.finish(kAnalysed.name);
    return *d->analysis;
}

} // namespace fff
