// SPDX-License-Identifier: MIT
// Memory of answers, counted from the acceptance of a request until the last byte of its answer is sent.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "dispatcher.hpp"

class AnswerRooms {
    struct Books {
        std::size_t bytes = 0;
        std::map<std::string, std::weak_ptr<class AnswerRoom>> by_tag;
    };
    friend class AnswerRoom;

public:
    explicit AnswerRooms(std::size_t limit) : limit_(limit) {}

    /// Returns the room of the answer with this entity tag. All requests with an equal tag share a room,
    /// because their answer is in memory once. A new room counts `most` bytes until its answer is known.
    /// Returns null if the limit would be exceeded, but an answer larger than the limit gets a room if there
    /// is no other one.
    std::shared_ptr<class AnswerRoom> reserve(const std::string& tag, std::size_t most);
    /// Returns the bytes of all rooms.
    [[nodiscard]] std::size_t bytes() const { return books_->bytes; }

private:
    std::size_t limit_;
    std::shared_ptr<Books> books_ = std::make_shared<Books>();  ///< outlives the connections that hold rooms
};

class AnswerRoom {
public:
    AnswerRoom(std::shared_ptr<AnswerRooms::Books> books, std::string tag, std::size_t bytes);
    ~AnswerRoom();
    AnswerRoom(const AnswerRoom&) = delete;
    AnswerRoom& operator=(const AnswerRoom&) = delete;

    /// Keeps the answer as long as the room, which counts the answer's size from now on.
    void settle(const AnswerPtr& answer);
    /// Returns the answer, null before settle().
    [[nodiscard]] const AnswerPtr& answer() const { return answer_; }

private:
    std::shared_ptr<AnswerRooms::Books> books_;
    std::string tag_;
    std::size_t bytes_;
    AnswerPtr answer_;
};
