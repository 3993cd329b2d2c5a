// The samples are what a newcomer sees first: they must be sound.
#include <QTest>

#include "core/analysis/checks.h"
#include "core/analysis/plan_checks.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/model/told_names.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"
#include "ui/settings/languages.h"
#include "ui/start/sample_texts.h"
#include "ui/start/samples.h"

#include <QSet>
#include <QTranslator>

#include <algorithm>

using namespace fff;

class TestSamples : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thereAreSeveral();
    void eachHoldsAndCanBeMade_data();
    void eachHoldsAndCanBeMade();
    void everyOperationIsInOne();
    void everyNameCanBeTold();
    void inEveryLanguageTheyAreTheSame_data();
    void inEveryLanguageTheyAreTheSame();
};

void TestSamples::thereAreSeveral()
{
    QSet<QString> names;
    for (const ui::Sample &sample : ui::samples())
        names += sample.name;
    QVERIFY(names.size() >= 6);
    QCOMPARE(names.size(), ui::samples().size());
}

void TestSamples::eachHoldsAndCanBeMade_data()
{
    QTest::addColumn<QString>("path");
    for (const ui::Sample &sample : ui::samples())
        QTest::addRow("%s", qPrintable(sample.name)) << sample.path;
}

void TestSamples::eachHoldsAndCanBeMade()
{
    QFETCH(QString, path);
    const Result<io::LoadedDocument> loaded = io::readDocument(path);
    QVERIFY(loaded);
    QVERIFY(loaded->warnings.empty());
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(loaded->document), caches);
    for (const OperationResultPointer &result : analysis.model.evaluation.results)
        QVERIFY2(result->notices.empty(), result->operation->name.c_str());
    std::vector<Finding> found = planChecks(analysis, planOf(analysis));
    for (Finding &finding : checks(analysis))
        found.push_back(std::move(finding));
    for (const Finding &finding : found)
        QVERIFY2(finding.severity < Severity::Warning,
                 finding.sections.empty() ? "the model" : "a section");
    for (const FindingKind *kind : {&kConnected, &kStands, &kCanAssemble, &kFitsSheet})
        QVERIFY(std::any_of(found.begin(), found.end(),
                            [kind](const Finding &finding) { return finding.is(*kind); }));
    const Result<io::CuttingFile> file = io::makeCuttingFile(analysis);
    QVERIFY(file);
    QCOMPARE(file->partCount, static_cast<int>(analysis.model.sectionCount()));
    QVERIFY(file->oversized.empty());
    QVERIFY(file->unmarked.empty());
    QVERIFY(file->unmarkedJoints.empty());
}

// Wrong: an operation that nobody sees at work before trying it.
void TestSamples::everyOperationIsInOne()
{
    QSet<QString> kinds;
    for (const ui::Sample &sample : ui::samples()) {
        const Result<io::LoadedDocument> loaded = io::readDocument(sample.path);
        QVERIFY(loaded);
        for (const OperationPointer &operation : loaded->document.operations)
            kinds += QString::fromStdString(operation->kind);
    }
    for (const OperationKind *kind : operationKinds())
        QVERIFY2(kinds.contains(QString::fromUtf8(kind->key)), kind->key);
}

// Wrong: a window in Japanese with "Front legs" in it.
void TestSamples::everyNameCanBeTold()
{
    const QStringList known = ui::sampleTexts();
    for (const ui::Sample &sample : ui::samples()) {
        const Result<io::LoadedDocument> loaded = io::readDocument(sample.path);
        QVERIFY(loaded);
        QStringList missing;
        withNamesTold(loaded->document, [&](const std::string &name) {
            if (!known.contains(QString::fromStdString(name)))
                missing += QString::fromStdString(name);
            return name;
        });
        QVERIFY2(missing.isEmpty(), qPrintable(sample.name + QStringLiteral(": ") +
                                               missing.join(QStringLiteral(", "))));
    }
}

void TestSamples::inEveryLanguageTheyAreTheSame_data()
{
    QTest::addColumn<QString>("language");
    for (const QString &language : ui::languagesThere())
        QTest::newRow(qPrintable(language)) << language;
}

// Wrong: a value whose name cannot be one there, or is another one's, and what is made of it.
void TestSamples::inEveryLanguageTheyAreTheSame()
{
    QFETCH(QString, language);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/i18n/flatfitfab_") + language));
    for (const ui::Sample &sample : ui::samples()) {
        const Document english = io::readDocument(sample.path)->document;
        QCoreApplication::installTranslator(&translator);
        const Document told = ui::inThisLanguage(english);
        QCoreApplication::removeTranslator(&translator);
        const Model before = evaluate(english), after = evaluate(told);
        QVERIFY(after.evaluation.values.wrong().empty());
        QVERIFY(after.evaluation.drivingErrors.empty());
        QCOMPARE(after.sectionCount(), before.sectionCount());
        for (std::size_t i = 0; i < after.sectionCount(); ++i) {
            QVERIFY(*after.section(i)->shape == *before.section(i)->shape);
            QVERIFY(after.section(i)->frame == before.section(i)->frame);
        }
        if (language == QStringLiteral("en"))
            continue;
        for (std::size_t i = 0; i < told.values.list.size(); ++i) {
            const std::string &name = english.values.list[i]->value.name;
            const QString wanted = translator.translate("fff::ui::SampleTexts", name.c_str());
            QCOMPARE(QString::fromStdString(told.values.list[i]->value.name), wanted);
        }
    }
}

FFF_TEST(TestSamples)
#include "tst_samples.moc"
