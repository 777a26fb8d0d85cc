#include "ui/swing/SwingEditor.h"

#include <algorithm>
#include <utility>

#include "core/swing/Observations.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SwingMarks.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

/// More readings than this are computed on a worker: nobody types so many, and their results take longer than a keystroke may. The same
/// number as that beyond which the store leaves results to who computes them.
constexpr std::size_t kComputedAtOnce = db::kRefreshedAtOnce;

} // namespace

SwingEditor::SwingEditor(EditContext& context, QUndoStack& stack, QObject* parent)
    : QObject(parent)
    , m_context(context)
    , m_stores(context.stores)
    , m_stack(stack)
    , m_worker(
          [this](Result<Analysis> result) {
              if (!m_computing) // a swing of few readings is shown since
                  return;
              take(std::move(result));
              keepResult();
              emit computed();
          },
          [this](int percent) { emit computingProgressed(percent); })
    , m_previousWorker([this](Result<Analysis> result) {
        if (!result || !std::exchange(m_previousComputing, false)) // of another swing's previous one
            return;
        m_previousAnalysis = std::make_shared<const Analysis>(std::move(result.value()));
        emit computed();
    })
{
    connect(&context.stores.changes(), &db::Changes::swingChanged, this, &SwingEditor::onSwingChanged);
    // An aircraft's or a compass's particulars (its limits) are part of what is shown.
    connect(&context.stores.changes(), &db::Changes::aircraftChanged, this, [this] { onSwingChanged(this->id()); });
    connect(&context.stores.changes(), &db::Changes::fleetChanged, this, [this] { onSwingChanged(this->id()); });
    connect(&context.stores.changes(), &db::Changes::sitesChanged, this, [this] { onSwingChanged(this->id()); }); // its base and limits
}

SwingEditor::~SwingEditor()
{
    blockSignals(true); // the page is gone
    leave();
}

/// Nobody else computes what lists show of a log in which somebody typed. (What fails here, the next start does.)
void SwingEditor::leave()
{
    if (!m_computing || m_stores.readOnly())
        return;
    m_worker.cancel();
    m_computing = false;
    m_leaving = true; // what it hears of that is not read again
    (void)m_stores.results.catchUp(id());
    m_leaving = false;
}

Result<void> SwingEditor::open(SwingId id)
{
    auto record = m_context.stores.swings.record(id);
    if (!record)
        return record.error();
    leave();
    m_record = std::move(record.value());
    m_analysis.reset();
    readSiblings();
    analyseRecord();
    analysePrevious();
    emit opened();
    return {};
}

void SwingEditor::close()
{
    m_record = {};
    m_analysis.reset();
    analyseRecord();
    m_previous.reset();
    m_previousAnalysis.reset();
    m_siblings.reset();
    emit closed();
}

void SwingEditor::onSwingChanged(SwingId id, ReadingId only)
{
    if (!id.valid() || id != m_record.swing.id || m_leaving)
        return;
    if (!only.valid() || readings().size() <= kComputedAtOnce || !readAgain(only))
        readAgain();
}

/// One row of a log, so that a keystroke does not read all. @return whether that was possible.
bool SwingEditor::readAgain(ReadingId only)
{
    auto& rows = m_record.swing.readings;
    const auto row = std::find_if(rows.begin(), rows.end(), [only](const Reading& reading) { return reading.id == only; });
    auto stored = m_context.stores.swings.reading(id(), only);
    if (row == rows.end() || !stored)
        return false;
    if (*row == *stored)
        return true;
    const bool counts = row->used() != stored->used();
    *row = std::move(stored.value());
    m_changed = only;
    if (counts)
        m_used = usedReadings(m_record.swing);
    askForResult();
    emit readingChanged(static_cast<int>(row - rows.begin()));
    return true;
}

void SwingEditor::readAgain()
{
    auto record = m_context.stores.swings.record(id());
    if (!record) {
        if (record.error().code != ErrorCode::NotFound)
            m_context.failed(record.error());
        close();
        return;
    }
    if (record.value() == m_record)
        return;
    const bool otherPrevious = record->swing.date != m_record.swing.date || record->swing.compass != m_record.swing.compass;
    m_record = std::move(record.value());
    if (otherPrevious)
        readSiblings();
    analyseRecord();
    if (otherPrevious)
        analysePrevious();
    emit changed();
}

void SwingEditor::readSiblings()
{
    m_siblings.reset();
    if (auto siblings = m_context.stores.results.siblingsOf(m_record))
        m_siblings = *siblings;
    else
        m_context.failed(siblings.error());
}

void SwingEditor::analyseRecord()
{
    m_used = usedReadings(m_record.swing);
    askForResult();
}

void SwingEditor::askForResult()
{
    auto question = m_context.stores.results.questionOf(m_record, m_siblings);
    if (!question) {
        take(question.error());
        return;
    }
    if (question->readings.size() <= kComputedAtOnce) {
        take(answerTo(*question));
        return;
    }
    m_computing = true;
    const auto behind = m_context.stores.results.behind(id());
    m_behind = behind ? *behind : 0;
    if (!m_analysis)
        m_whyNoAnalysis = tr("it is being computed");
    m_worker.start([question = std::move(question.value())](const Progress& progress) { return answerTo(question, progress); });
}

void SwingEditor::take(Result<Analysis> result)
{
    m_worker.cancel(); // of the readings before
    m_computing = false;
    m_analysis.reset();
    m_whyNoAnalysis.clear();
    if (result)
        m_analysis = std::make_shared<const Analysis>(std::move(result.value()));
    else
        m_whyNoAnalysis = toText(result.error().message);
}

/// What the lists show of a log is kept with what was computed here: no keystroke waits for it.
void SwingEditor::keepResult()
{
    if (m_behind == 0 || m_context.stores.readOnly())
        return;
    const auto kept
        = m_analysis ? m_context.stores.results.keep(m_record, *m_analysis, m_behind, m_changed) : m_context.stores.results.catchUp(id());
    if (kept)
        m_behind = 0;
    else
        m_context.failed(kept.error());
}

void SwingEditor::settle()
{
    if (m_computing)
        m_worker.finish();
}

void SwingEditor::analysePrevious()
{
    m_previous.reset();
    m_previousAnalysis.reset();
    m_previousWorker.cancel();
    m_previousComputing = false;
    auto previous = m_context.stores.swings.previousRow(id());
    if (!previous) {
        m_context.failed(previous.error());
        return;
    }
    m_previous = std::move(previous.value());
    if (!m_previous)
        return;
    auto question = m_context.stores.results.questionOf(m_previous->id);
    if (!question)
        return;
    m_previousComputing = question->readings.size() > kComputedAtOnce;
    if (m_previousComputing)
        m_previousWorker.start([question = std::move(question.value())](const Progress& progress) { return answerTo(question, progress); });
    else if (auto result = answerTo(*question))
        m_previousAnalysis = std::make_shared<const Analysis>(std::move(result.value()));
}

int SwingEditor::analysedIndex(int row) const
{
    const auto found = std::lower_bound(m_used.begin(), m_used.end(), static_cast<std::size_t>(row));
    const bool used = row >= 0 && found != m_used.end() && *found == static_cast<std::size_t>(row);
    const int index = used ? static_cast<int>(found - m_used.begin()) : -1;
    if (!m_computing || index < 0)
        return index;
    const auto place = static_cast<std::size_t>(index);
    const Observation now = observationOf(m_record.swing, readings()[static_cast<std::size_t>(row)]);
    const bool same = m_analysis && place < m_analysis->readings.size() && isOf(m_analysis->readings[place], now);
    return same ? index : -1;
}

int SwingEditor::rowOf(ReadingId reading) const
{
    const auto found = std::find_if(readings().begin(), readings().end(), [reading](const Reading& one) { return one.id == reading; });
    return found == readings().end() ? -1 : static_cast<int>(found - readings().begin());
}

const AnalysedReading* SwingEditor::analysed(int row) const
{
    const int index = analysedIndex(row);
    return m_analysis && index >= 0 ? &m_analysis->readings[static_cast<std::size_t>(index)] : nullptr;
}

QString SwingEditor::whyReadOnly() const
{
    if (m_context.stores.readOnly())
        return tr("This database can only be read.");
    if (m_record.swing.state == SwingState::Signed) {
        if (db::signedMark(m_context.stores.database(), id(), m_record.swing.state) == db::SignedMark::Stands)
            return tr("This swing is signed: it is frozen.");
        return m_record.swing.signatures.empty()
            ? tr("This swing is frozen as a signed one, but nobody's signature is there: it is printed as not signed. Amend it to sign it.")
            : tr(
                "This swing is frozen as a signed one, but its signatures do not stand over what it says now: it is printed as not signed. Amend it to sign it.");
    }
    if (m_record.swing.state == SwingState::Complete)
        return tr("This swing is complete. To change a reading, open it again.");
    return {};
}

bool SwingEditor::particularsEditable() const
{
    return id().valid() && !m_context.stores.readOnly() && m_record.swing.state != SwingState::Signed;
}

} // namespace lubberline::ui
