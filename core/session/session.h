// The current model, its history and what is derived from it, for one open document. Holds no
// widget.
#pragma once

#include "core/analysis/analysis.h"
#include "core/base/result.h"
#include "core/model/model.h"

#include <QObject>
#include <QUndoStack>

#include <cstdint>
#include <memory>
#include <vector>

namespace fff {

class Scheduler;
struct Stage;

class Session : public QObject
{
    Q_OBJECT
public:
    explicit Session(QObject *parent = nullptr);
    /// With other stages than those that the product has.
    explicit Session(std::vector<Stage> stages, QObject *parent = nullptr);
    ~Session() override;

    /// What is shown: the preview while one runs, else the committed model.
    const Model &model() const;
    const Model &committed() const;
    bool hasPreview() const;

    /// Another document (New, Open): the history starts anew and is clean; announced as one change.
    void reset(Document document);
    /// Shows `document` without a step. Each preview starts from the committed document.
    void preview(Document document);
    void cancelPreview();
    /// One undo step named `text`, from the committed document to this one. No step when it is the
    /// same document (Document::isSame). Ends a preview.
    /// merges: not empty: one step with the one before, when that was committed with the same (and
    /// is not what is saved).
    void commit(const QString &text, Document document, const std::string &merges = {});

    /// Undo, redo, jump: every change of index is announced once, from where it was to where it is.
    QUndoStack *history() const;
    /// What was committed after so many steps of the history: 0 before the first one. Null when
    /// there are not so many. What operations made of it may be made anew for that.
    std::shared_ptr<const Model> modelAfter(int steps) const;
    bool isClean() const;
    void setClean(); // saved
    /// This document is on disk now. It may be an earlier or later step than what is committed by
    /// then: clean is the step that it is; when the history has it no more, none is.
    void setSaved(const Document &document);
    /// What is shown is on no disk (recovered after a crash): not clean until it is saved.
    void setUnsaved();

    /// Counts up with every change of model().
    std::uint64_t revision() const;

    /// Works out what is derived from what is shown.
    Scheduler &scheduler() const;
    /// The newest finished analysis (of an older revision while one is running).
    const Analysis &analysis() const;
    /// The same, to be kept.
    const AnalysisPointer &analysisPointer() const;
    std::uint64_t analysedRevision() const;
    /// Blocks until analysis() belongs to revision(), or could not be worked out.
    const Analysis &currentAnalysis();

Q_SIGNALS:
    /// Another document comes in the place of this one (reset); modelChanged follows.
    void replaced();
    void modelChanged(const fff::Model &before, const fff::Model &after);
    /// committed() is another one, also where what is shown stays: a preview was committed.
    void committedChanged();
    void analysisChanged();
    void cleanChanged(bool clean);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff
