// SPDX-License-Identifier: MIT
#include "metrics.hpp"

#include "json.hpp"

namespace {

/// Prefix of every name.
constexpr const char* kPrefix = "nicol_serve_";

std::string head(const std::string& name, const char* type, const char* help) {
    return "# HELP " + (kPrefix + name) + " " + help + "\n# TYPE " + kPrefix + name + " " + type + "\n";
}

std::string line(const std::string& name, const std::string& labels, const std::string& value) {
    return kPrefix + name + (labels.empty() ? "" : "{" + labels + "}") + " " + value + "\n";
}

std::string single(const std::string& name, const char* type, const char* help, std::uint64_t value) {
    return head(name, type, help) + line(name, "", std::to_string(value));
}

std::string label(const char* name, const std::string& value) {
    return name + ("=\"" + value) + "\"";
}

std::string worker_lines(const std::vector<WorkerState>& workers) {
    std::string text = head("worker", "gauge", "1 for each worker process, in its state.");
    std::string memory = head("worker_resident_bytes", "gauge", "Memory of each worker process.");
    for (std::size_t i = 0; i < workers.size(); ++i) {
        const std::string who =
            label("slot", std::to_string(i)) + "," + label("pid", std::to_string(workers[i].pid));
        text += line("worker", who + "," + label("state", workers[i].state), "1");
        memory += line("worker_resident_bytes", who, std::to_string(workers[i].resident_bytes));
    }
    return text + memory;
}

}  // namespace

void Histogram::add(double seconds) {
    for (std::size_t i = 0; i < kBounds.size(); ++i)
        if (seconds <= kBounds[i]) ++counts_[i];
    ++count_;
    sum_ += seconds;
}

std::string Histogram::text(const std::string& name, const std::string& labels) const {
    const std::string comma = labels.empty() ? "" : labels + ",";
    std::string result;
    for (std::size_t i = 0; i < kBounds.size(); ++i)
        result +=
            line(name + "_bucket", comma + label("le", json_number(kBounds[i])), std::to_string(counts_[i]));
    result += line(name + "_bucket", comma + label("le", "+Inf"), std::to_string(count_));
    result += line(name + "_sum", labels, json_number(sum_));
    return result + line(name + "_count", labels, std::to_string(count_));
}

void Metrics::rendered(const ResultHead& result) {
    ++renders;
    hits_view += result.unchanged;
    double sum = 0;
    for (std::size_t i = 0; i < by_verb.size(); ++i) {
        const double seconds = result.ms[i] / 1000;
        if (seconds > 0) by_verb[i].add(seconds);
        sum += seconds;
    }
    render_seconds.add(sum);
}

std::string Metrics::text(const Gauges& now) const {
    std::string text = head("requests_total", "counter", "Requests by status of the answer.");
    for (const auto& [status, count] : requests)
        text += line("requests_total", label("status", std::to_string(status)), std::to_string(count));
    text += single("renders_total", "counter", "Images made by workers.", renders);
    text += head("cache_hits_total", "counter",
                 "Answers without a new render: by entity tag (304), kept results, equal requests in flight, "
                 "views that a worker still had.");
    text += line("cache_hits_total", label("kind", "tag"), std::to_string(hits_tag));
    text += line("cache_hits_total", label("kind", "result"), std::to_string(hits_result));
    text += line("cache_hits_total", label("kind", "flight"), std::to_string(hits_flight));
    text += line("cache_hits_total", label("kind", "view"), std::to_string(hits_view));
    text += single("queue_refused_total", "counter", "Requests that found the queue full.", refused_queue);
    text += single("connections_displaced_total", "counter", "Idle connections that made room for others.",
                   displaced);
    text += single("clients_gone_total", "counter", "Clients that left before their answer.", clients_gone);
    text += single("renders_cancelled_total", "counter",
                   "Renders that were cancelled because all clients left.", cancelled);
    text += head("workers_lost_total", "counter", "Worker processes that had to be replaced.");
    text += line("workers_lost_total", label("reason", "crash"), std::to_string(crashed));
    text += line("workers_lost_total", label("reason", "hang"), std::to_string(hung));
    text += single("queue_length", "gauge", "Requests in the queue.", now.queued);
    text += single("renders_running", "gauge", "Renders under way.", now.running);
    text += single("connections", "gauge", "Open connections.", now.connections);
    text += single("result_bytes", "gauge", "Answers kept for equal requests.", now.cached_bytes);
    text += single("answer_bytes", "gauge", "Images that are being sent.", now.answer_bytes);
    text += single("ready", "gauge", "1 where images are to be had.", now.ready ? 1 : 0);
    text += worker_lines(now.workers);
    text += head("answer_seconds", "histogram", "From request to answer, of images.");
    text += waited.text("answer_seconds", "");
    text += head("render_seconds", "histogram", "Work of an image in its worker.");
    text += render_seconds.text("render_seconds", "");
    text += head("verb_seconds", "histogram", "Time of each verb of the renderer where it ran.");
    for (std::size_t i = 0; i < kVerbs.size(); ++i)
        text += by_verb[i].text("verb_seconds", label("verb", kVerbs[i]));
    return text;
}
