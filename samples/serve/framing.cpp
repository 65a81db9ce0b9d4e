// SPDX-License-Identifier: MIT
#include "framing.hpp"

#include <algorithm>
#include <boost/beast/http/rfc7230.hpp>
#include <iterator>

namespace beast = boost::beast;
namespace http = boost::beast::http;

namespace {

using Header = http::request_header<>;
constexpr unsigned kVersion11 = 11;

/// Returns whether a header line is folded (RFC 9112, 5.2). The parser joins folded lines and other parsers
/// do not, so two readers may see different requests.
bool is_folded(std::string_view bytes) {
    return bytes.find("\r\n ") != std::string_view::npos || bytes.find("\r\n\t") != std::string_view::npos;
}

/// Returns whether Host follows RFC 9112, 3.2, with characters of an authority without user information (RFC
/// 3986).
bool has_good_host(const Header& header) {
    const auto count = header.count(http::field::host);
    if (count != 1) return count == 0 && header.version() < kVersion11;
    const beast::string_view host = header[http::field::host];
    return std::ranges::all_of(host, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-._~!$&'()*+,;=%:[]").find(c) != std::string_view::npos;
    });
}

/// Returns the problem of a transfer coding by RFC 9112, 6.1 and 6.3.
std::optional<Problem> refused_coding(const Header& header) {
    const auto coding = header.find(http::field::transfer_encoding);
    if (coding == header.end() ||
        (header.version() >= kVersion11 && beast::iequals(coding->value(), "chunked")))
        return {};
    const beast::string_view list = coding->value();
    const http::token_list codings(list);
    const auto chunked = std::find_if(codings.begin(), codings.end(), [](beast::string_view name) {
        return beast::iequals(name, "chunked");
    });
    // chunked must occur once, as the last coding.
    const bool ends = chunked != codings.end() && std::next(chunked) == codings.end();
    if (header.version() < kVersion11 || !ends)
        return Problem{.status = 400,
                       .detail = "Where the request ends cannot be told from Transfer-Encoding."};
    return Problem{.status = 501, .detail = "Of transfer codings there is chunked alone."};
}

}  // namespace

std::optional<Problem> refused_header(std::string_view bytes, const Header& header) {
    if (is_folded(bytes))
        return Problem{.status = 400, .detail = "A line of the request's header begins with a space."};
    if (!has_good_host(header))
        return Problem{.status = 400, .detail = "A request needs one Host, the name of a host."};
    if (auto problem = refused_coding(header)) return problem;
    if (header.count(http::field::expect) > 0 && header.version() >= kVersion11 && !expects_continue(header))
        return Problem{.status = 417, .detail = "Only Expect: 100-continue can be met."};
    return {};
}

bool expects_continue(const Header& header) {
    return header.version() >= kVersion11 && beast::iequals(header[http::field::expect], "100-continue");
}
