// SPDX-License-Identifier: MIT
#include "answer_rooms.hpp"

#include <utility>

std::shared_ptr<AnswerRoom> AnswerRooms::reserve(const std::string& tag, std::size_t most) {
    if (const auto known = books_->by_tag.find(tag); known != books_->by_tag.end())
        return known->second.lock();
    if (books_->bytes > 0 && books_->bytes + most > limit_) return nullptr;
    auto room = std::make_shared<AnswerRoom>(books_, tag, most);
    books_->by_tag.emplace(tag, room);
    return room;
}

AnswerRoom::AnswerRoom(std::shared_ptr<AnswerRooms::Books> books, std::string tag, std::size_t bytes)
    : books_(std::move(books)), tag_(std::move(tag)), bytes_(bytes) {
    books_->bytes += bytes_;
}

AnswerRoom::~AnswerRoom() {
    books_->bytes -= bytes_;
    books_->by_tag.erase(tag_);
}

void AnswerRoom::settle(const AnswerPtr& answer) {
    books_->bytes += answer->content.size() - bytes_;
    bytes_ = answer->content.size();
    answer_ = answer;
}
