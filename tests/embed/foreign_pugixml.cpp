// SPDX-License-Identifier: MIT
// Members of the host's own pugixml, which is compiled for wide characters and exported by the program. Their
// names equal those of the usual pugixml. Nicol must call none of them.
#define PUGIXML_WCHAR_MODE
#include <cstdio>
#include <cstdlib>
#include <pugixml.hpp>

namespace {

[[noreturn]] void called(const char* name) {
    std::fprintf(stderr, "Nicol called the host's pugi::%s\n", name);
    std::abort();
}

}  // namespace

namespace pugi {

xml_document::xml_document() {
    called("xml_document::xml_document()");
}
xml_document::~xml_document() {
    called("xml_document::~xml_document()");
}
xml_parse_result xml_document::load_buffer(const void*, size_t, unsigned int, xml_encoding) {
    called("xml_document::load_buffer()");
}
xml_node::xml_node() {
    called("xml_node::xml_node()");
}
xml_node xml_node::first_child() const {
    called("xml_node::first_child()");
}
xml_attribute xml_node::first_attribute() const {
    called("xml_node::first_attribute()");
}
const char_t* xml_node::name() const {
    called("xml_node::name()");
}
const char_t* xml_attribute::value() const {
    called("xml_attribute::value()");
}

}  // namespace pugi
