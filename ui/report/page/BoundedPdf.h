#pragma once
/// What qpdf decompresses has a limit: a PDF of a few kilobytes can ask for gigabytes, in an attachment, in its table of objects or in a
/// stream of objects.

#include <cstddef>

namespace lubberline::ui {

class PdfLimit {
public:
    /// While it lives, the streams that qpdf decodes in this thread may give so many bytes together; more is an exception of qpdf.
    explicit PdfLimit(std::size_t bytes);
    ~PdfLimit();
    PdfLimit(const PdfLimit&) = delete;
    PdfLimit& operator=(const PdfLimit&) = delete;
    [[nodiscard]] bool reached() const;
};

} // namespace lubberline::ui
