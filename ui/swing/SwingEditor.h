#pragma once
/// The swing that is shown: its record as storage has it, its results, and the undoable verbs that change it.
/// After every change the record is read back from storage: what is on screen is what is on disk. The results of a log are computed on a
/// worker, and those of before stay until they are there.

#include <QObject>

#include <memory>
#include <vector>

#include "core/swing/Analysis.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/Worker.h"

class QUndoStack;
class QUndoCommand;

namespace lubberline::ui {

class SwingEditor : public QObject {
    Q_OBJECT

public:
    SwingEditor(EditContext& context, QUndoStack& stack, QObject* parent = nullptr);
    ~SwingEditor() override;

    /// Shows another swing. Errors: those of SwingStore::record(); what was shown stays then.
    Result<void> open(SwingId id);
    void close();

    [[nodiscard]] SwingId id() const { return m_record.swing.id; }
    [[nodiscard]] const SwingRecord& record() const { return m_record; }
    [[nodiscard]] const std::vector<Reading>& readings() const { return m_record.swing.readings; }
    /// Null while the readings do not allow a result, or the first one is being computed; whyNoAnalysis() then says why.
    /// While computing(): that of the readings before the last change. Nothing of it is printed or signed: settle() first.
    [[nodiscard]] const std::shared_ptr<const Analysis>& analysis() const { return m_analysis; }
    [[nodiscard]] bool computing() const { return m_computing; }
    /// Waits until the results are those of the readings.
    void settle();
    [[nodiscard]] const QString& whyNoAnalysis() const { return m_whyNoAnalysis; }
    [[nodiscard]] int rowOf(ReadingId reading) const; ///< −1: it is none of this swing
    /// The results of one row; null when it is not used, or without analysis.
    [[nodiscard]] const AnalysedReading* analysed(int row) const;
    /// The place of a row among the analysed readings, or −1; likewise where it was another reading when they were computed.
    [[nodiscard]] int analysedIndex(int row) const;
    [[nodiscard]] const std::optional<SwingRow>& previous() const { return m_previous; }
    [[nodiscard]] const std::shared_ptr<const Analysis>& previousAnalysis() const { return m_previousAnalysis; }
    /// What the other aircraft of its type let expect of a compass without a swing before (db::ResultStore::siblingsOf()).
    [[nodiscard]] const std::optional<ExpectedCurve>& siblings() const { return m_siblings; }

    /// Why nothing can be changed: signed, complete, or a database that can only be read. Empty: it can.
    [[nodiscard]] QString whyReadOnly() const;
    [[nodiscard]] bool editable() const { return id().valid() && whyReadOnly().isEmpty(); }
    /// Particulars and the state may be changed until it is signed.
    [[nodiscard]] bool particularsEditable() const;
    [[nodiscard]] const db::Stores& stores() const { return m_context.stores; }
    [[nodiscard]] db::Stores& stores() { return m_context.stores; }

    // Verbs. @return whether it is on disk; if not, failureMessage() says why (and EditContext::failed was told).
    bool changeReading(int row, const Reading& after, const QString& what);
    /// All rows as they are to be: those that differ are changed, and what goes beyond the last one is added; one step of undo.
    bool putReadings(const std::vector<Reading>& after, const QString& what);
    bool insertReadings(int position, std::vector<Reading> readings, const QString& what);
    bool removeReadings(std::vector<int> rows);
    bool layOutNominals(int points);
    bool changeParticulars(const Swing& after, const QString& what);
    bool complete();                              ///< draft → complete
    bool exclude(int row, const QString& reason); ///< empty reason: counts again
    [[nodiscard]] const QString& failureMessage() const { return m_failure; }
    [[nodiscard]] bool waits() const { return m_waits; } ///< the last failure was that another program is writing: it will be free again

signals:
    void opened();                ///< another swing is shown
    void changed();               ///< the same swing, another record or other results
    void readingChanged(int row); ///< changed() for one row of a log, where nothing else has
    void computed();              ///< results are there that were being computed
    void computingProgressed(int percent);
    void closed();
    /// A row that could not be stored because the drive or the database failed: to be kept elsewhere.
    /// @param before as it was known; without an id: a new row
    void notStored(int row, const lubberline::Reading& before, const lubberline::Reading& wanted);

private:
    void onSwingChanged(SwingId id, ReadingId only = {});
    void readAgain();
    bool readAgain(ReadingId only);
    void readSiblings();
    void analyseRecord();
    void askForResult(); ///< of the readings that are known to count
    void take(Result<Analysis> result);
    void keepResult();
    void leave();
    void analysePrevious();
    bool run(QUndoCommand* edit);

    EditContext& m_context;
    db::Stores& m_stores; ///< that of the context, which may be gone before
    QUndoStack& m_stack;
    SwingRecord m_record;
    std::vector<std::size_t> m_used;
    std::shared_ptr<const Analysis> m_analysis;
    QString m_whyNoAnalysis;
    bool m_computing = false, m_previousComputing = false, m_leaving = false;
    int m_behind = 0;    ///< of the readings that are being computed (db::ResultStore)
    ReadingId m_changed; ///< last
    std::optional<SwingRow> m_previous;
    std::shared_ptr<const Analysis> m_previousAnalysis;
    std::optional<ExpectedCurve> m_siblings;
    QString m_failure;
    bool m_waits = false;
    bool m_lost = false; ///< the last failure was of the drive, not of what was typed
    Worker<Analysis> m_worker;
    Worker<Analysis> m_previousWorker;
};

} // namespace lubberline::ui
