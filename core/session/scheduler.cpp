#include "core/analysis/nested.h"
#include "core/session/scheduler_private.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

Questions withoutSheets(Questions questions)
{
    questions.sheets.reset();
    return questions;
}

} // namespace

Scheduler::Scheduler(std::vector<Stage> stages, QObject *parent)
    : QObject(parent), d(std::make_unique<Private>(this, std::move(stages)))
{
}

Scheduler::~Scheduler()
{
    for (Private::Desk &desk : d->desks)
        desk.worker.request_stop();
}

void Scheduler::want(std::string_view stage)
{
    d->want(d->desk(stage));
    d->startAll();
    d->follow();
}

void Scheduler::request(std::uint64_t revision, ModelPointer model, bool isPassing)
{
    d->revision = revision;
    d->isPassing = isPassing;
    d->given[kModel.name] = std::move(model);
    d->startAll();
    d->follow();
}

void Scheduler::forget()
{
    ++d->generation;
    d->given.erase(kModel.name);
    d->questions = {};
    d->given[kQuestions.name] = std::make_shared<const Questions>();
    d->given[kSheetsAsked.name] = nullptr;
    for (Private::Desk &desk : d->desks) {
        desk.worker.request_stop();
        desk.started.clear();
        desk.why.reset();
    }
}

void Scheduler::setRules(const CheckRules &rules)
{
    if (rules == d->rules)
        return;
    d->rules = rules;
    d->given[kRules.name] = std::make_shared<const CheckRules>(rules);
    d->startAll();
    d->follow();
}

const CheckRules &Scheduler::rules() const
{
    return d->rules;
}

void Scheduler::ask(const Questions &questions)
{
    if (questions == d->questions)
        return;
    const Questions before = std::exchange(d->questions, questions);
    if (questions.sheets != before.sheets)
        d->askAnew(kSheetsAsked.name, questions.sheets);
    if (withoutSheets(questions) != withoutSheets(before))
        d->askAnew(kQuestions.name, std::make_shared<const Questions>(withoutSheets(questions)));
    d->startAll();
    d->follow();
    Q_EMIT asked();
}

const Questions &Scheduler::questions() const
{
    return d->questions;
}

std::shared_ptr<const void> Scheduler::resultNamed(std::string_view stage) const
{
    return d->desk(stage).result;
}

std::uint64_t Scheduler::revisionOf(std::string_view stage) const
{
    return d->desk(stage).revision;
}

Scheduler::Age Scheduler::age(std::string_view stage) const
{
    const Private::Desk &desk = d->desk(stage);
    if (!desk.isWanted)
        return Age::Current;
    if (!d->isSettled(desk))
        return d->age;
    const bool isForSettled = desk.stage->runs == Stage::Runs::WhenSettled;
    // What has failed, or stands on what has, stays older.
    return desk.revision == d->revision || (isForSettled && d->isPassing) ? Age::Current
                                                                          : Age::Late;
}

bool Scheduler::isRunning(std::string_view stage) const
{
    return d->desk(stage).isRunning;
}

bool Scheduler::isSettled(std::string_view stage) const
{
    return d->isSettled(d->desk(stage));
}

double Scheduler::progress(std::string_view stage) const
{
    const auto &progress = d->desk(stage).progress;
    return progress ? progress->share() : -1.0;
}

const std::optional<Error> &Scheduler::failureOf(std::string_view stage) const
{
    return d->desk(stage).why;
}

std::optional<Error> Scheduler::whyNot(std::string_view stage) const
{
    const Private::Desk &desk = d->desk(stage);
    for (const Private::Desk *input : desk.inputs)
        if (const auto why = whyNot(input->stage->name))
            return why;
    return desk.why;
}

void Scheduler::cancel(std::string_view stage)
{
    d->desk(stage).worker.request_stop();
}

void Scheduler::tryAgain(std::string_view stage)
{
    Private::Desk &desk = d->desk(stage);
    if (desk.isRunning)
        return;
    desk.started.clear();
    desk.why.reset();
    d->startAll();
    d->follow();
    Q_EMIT aged();
}

void Scheduler::finish(std::string_view stage)
{
    while (!d->isSettled(d->desk(stage))) {
        {
            std::unique_lock lock(d->mutex);
            d->isReady.wait(lock, [this] { return !d->outcomes.empty(); });
        }
        d->collectOne();
    }
}

void Scheduler::finish()
{
    for (const Stage &stage : d->stages)
        finish(stage.name);
}

void Scheduler::tidy()
{
    const auto runs = [](const Private::Desk &desk) { return desk.isRunning; };
    if (std::any_of(d->desks.begin(), d->desks.end(), runs))
        return;
    for (const Private::Desk &desk : d->desks)
        if (desk.stage->tidy && desk.previous)
            desk.stage->tidy(desk.previous.get());
}

const std::vector<Stage> &Scheduler::stages() const
{
    return d->stages;
}

void Scheduler::setCompute(std::string_view stage, decltype(Stage::compute) compute)
{
    const auto at = std::find_if(d->stages.begin(), d->stages.end(),
                                 [&](const Stage &known) { return stage == known.name; });
    at->compute = std::move(compute);
}

} // namespace fff
