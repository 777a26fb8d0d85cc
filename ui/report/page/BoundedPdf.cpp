#include "ui/report/page/BoundedPdf.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <vector>

#include <qpdf/Pl_Flate.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFLogger.hh>
#include <qpdf/QPDFStreamFilter.hh>

namespace lubberline::ui {

namespace {

struct Budget {
    bool counts = false, reached = false;
    std::size_t left = 0;
};
thread_local Budget t_budget; // qpdf asks for filters by name, from inside

/// Counts what goes through.
class Counter : public Pipeline {
public:
    explicit Counter(Pipeline* after) : Pipeline("count", after) {}
    void write(const unsigned char* data, std::size_t size) override
    {
        if (t_budget.counts && (t_budget.reached || size > t_budget.left)) {
            t_budget.reached = true;
            throw std::runtime_error("it holds more than it may");
        }
        t_budget.left -= std::min(size, t_budget.left);
        getNext()->write(data, size);
    }
    void finish() override { getNext()->finish(); }
};

/// The predictors of PNG (PDF Reference 1.7, 3.3.3): a byte in front of each row says what its bytes are the differences to.
class PngRows : public Pipeline {
public:
    PngRows(Pipeline* after, std::size_t row, std::size_t pixel) : Pipeline("png", after), m_pixel(pixel), m_before(row), m_row(row) {}
    void write(const unsigned char* data, std::size_t size) override
    {
        for (std::size_t i = 0; i < size; ++i)
            take(data[i]);
    }
    void finish() override
    {
        if (m_taken > 1)
            getNext()->write(m_row.data(), m_taken - 1);
        getNext()->finish();
    }

private:
    void take(unsigned char byte)
    {
        if (m_taken++ == 0) {
            m_kind = byte;
            return;
        }
        const std::size_t at = m_taken - 2;
        const int left = at >= m_pixel ? m_row[at - m_pixel] : 0, above = m_before[at], corner = at >= m_pixel ? m_before[at - m_pixel] : 0;
        m_row[at] = static_cast<unsigned char>(byte + predicted(left, above, corner));
        if (m_taken <= m_row.size())
            return;
        getNext()->write(m_row.data(), m_row.size());
        m_before.swap(m_row);
        m_taken = 0;
    }
    [[nodiscard]] int predicted(int left, int above, int corner) const
    {
        switch (m_kind) {
        case 1: return left;
        case 2: return above;
        case 3: return (left + above) / 2;
        case 4: { // Paeth's: whichever is nearest
            const int toLeft = std::abs(above - corner), toAbove = std::abs(left - corner), toCorner = std::abs(left + above - 2 * corner);
            return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
        }
        default: return 0;
        }
    }

    std::size_t m_pixel, m_taken = 0;
    std::vector<unsigned char> m_before, m_row;
    unsigned char m_kind = 0;
};

/// zlib's data, with or without PNG's predictors: what this program and those that save its PDFs again write.
class BoundedFlate : public QPDFStreamFilter {
public:
    bool setDecodeParms(QPDFObjectHandle parameters) override
    {
        if (!parameters.isDictionary())
            return parameters.isNull();
        const auto number = [&](const char* key, long long usual) {
            auto value = parameters.getKey(key); // its questions are not const
            return value.isInteger() ? value.getIntValue() : usual;
        };
        const long long predictor = number("/Predictor", 1), columns = number("/Columns", 1), colours = number("/Colors", 1),
                        bits = number("/BitsPerComponent", 8);
        constexpr long long kMostInRow = 1 << 16;
        if (predictor == 1)
            return true;
        if (predictor < 10 || predictor > 15 || columns < 1 || columns > kMostInRow || colours < 1 || colours > 32 || bits < 1 || bits > 16)
            return false;
        m_row = static_cast<std::size_t>((columns * colours * bits + 7) / 8);
        m_pixel = static_cast<std::size_t>(std::max(1LL, colours * bits / 8));
        return true;
    }
    Pipeline* getDecodePipeline(Pipeline* next) override
    {
        if (m_row > 0) {
            m_rows = std::make_unique<PngRows>(next, m_row, m_pixel);
            next = m_rows.get();
        }
        m_counter = std::make_unique<Counter>(next);
        m_flate = std::make_unique<Pl_Flate>("inflate", m_counter.get(), Pl_Flate::a_inflate);
        return m_flate.get();
    }

private:
    std::size_t m_row = 0, m_pixel = 1;
    std::unique_ptr<Pipeline> m_rows, m_counter, m_flate;
};

/// Old filters that nothing of ours writes, and whose output qpdf cannot count for us.
class Refused : public QPDFStreamFilter {
public:
    bool setDecodeParms(QPDFObjectHandle) override { return false; }
    Pipeline* getDecodePipeline(Pipeline*) override { return nullptr; }
};

void registerFilters()
{
    QPDF::registerStreamFilter("/FlateDecode", [] { return std::make_shared<BoundedFlate>(); });
    for (const char* name : {"/LZWDecode", "/RunLengthDecode", "/DCTDecode"})
        QPDF::registerStreamFilter(name, [] { return std::make_shared<Refused>(); });
    const auto logger = QPDFLogger::defaultLogger(); // of objects that belong to no file qpdf complains on standard error
    logger->setError(logger->discard());
}

} // namespace

PdfLimit::PdfLimit(std::size_t bytes)
{
    static std::once_flag once;
    std::call_once(once, registerFilters);
    t_budget = {true, false, bytes};
}

PdfLimit::~PdfLimit() { t_budget = {}; }

bool PdfLimit::reached() const { return t_budget.reached; }

} // namespace lubberline::ui
