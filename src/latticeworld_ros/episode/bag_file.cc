#include "latticeworld_ros/episode/bag_file.h"

#include <system_error>
#include <utility>

#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kChunkBytes = 768u << 10;
constexpr std::uint64_t kHeaderBytes = 256;  // of a record of the format, and more
constexpr std::uint64_t kEntryBytes = 16;    // of a message or a connection in an index
constexpr std::uint64_t kSlackBytes = 2u << 20;

rosbag::CompressionType ToRosbag(BagCompression compression) {
  switch (compression) {
    case BagCompression::kLz4:
      return rosbag::compression::LZ4;
    case BagCompression::kBz2:
      return rosbag::compression::BZ2;
    case BagCompression::kNone:
      break;
  }
  return rosbag::compression::Uncompressed;
}

}  // namespace

bool BagMessage::latched() const {
  if (header == nullptr) return false;
  const auto latching = header->find("latching");
  return latching != header->end() && latching->second == "1";
}

std::string BagMessage::caller() const {
  if (header == nullptr) return "";
  const auto caller = header->find("callerid");
  return caller == header->end() ? "" : caller->second;
}

BagFile::BagFile(fs::path path) : path_(path), active_path_(std::move(path += ".active")) {}

Result<std::unique_ptr<BagFile>> BagFile::Create(const fs::path& path, BagCompression compression) {
  std::unique_ptr<BagFile> file(new BagFile(path));
  std::error_code error;
  for (const fs::path& taken : {file->path_, file->active_path_}) {
    if (fs::exists(taken, error)) {
      return Status(StatusCode::kAlreadyExists, taken.string() + " exists");
    }
  }
  // Before there is a bag, which writes as it is opened, and again as it dies.
  Status room = WriteFile(file->active_path_, "");
  if (room.ok()) room = file->reserve_.Open(file->active_path_);
  if (room.ok()) room = file->reserve_.Ensure(file->IndexBytes());
  if (!room.ok()) {
    fs::remove(file->active_path_, error);
    return room;
  }
  std::unique_ptr<rosbag::Bag> bag;
  try {
    bag = std::make_unique<rosbag::Bag>();
    bag->open(file->active_path_.string(), rosbag::bagmode::Write);
    bag->setCompression(ToRosbag(compression));
    bag->setChunkThreshold(kChunkBytes);
    file->bag_ = std::move(bag);
  } catch (const std::exception& caught) {  // rosbag's, pluginlib's
    (void)bag.release();  // its destructor would write again, and end the process where that fails
    fs::remove(file->active_path_, error);
    return PermissionDenied("cannot write " + file->active_path_.string() + ": " + caught.what());
  }
  const Status opened = file->reserve_.Open(file->active_path_);
  room = opened.ok() ? file->reserve_.Ensure(file->IndexBytes()) : opened;
  if (!room.ok()) {
    (void)file->Finish();
    fs::remove(file->path_, error);
    return room;
  }
  return file;
}

BagFile::~BagFile() {
  if (bag_ != nullptr) (void)Finish();
}

std::uint64_t BagFile::IndexBytes() const {
  return kSlackBytes + definition_bytes_ + open_messages_ * kEntryBytes +
         connections_.size() * kHeaderBytes +
         (chunks_ + 1) * (kHeaderBytes + connections_.size() * kEntryBytes);
}

Status BagFile::Write(const BagMessage& message, bool last) {
  if (bag_ == nullptr) return Internal(active_path_.string() + " was given up");
  try {
    if (connections_.insert(message.topic + " " + message.caller()).second) {
      definition_bytes_ += 2 * (message.message->getMessageDefinition().size() + kHeaderBytes);
    }
    // What is compressed may grow a little.
    const std::uint64_t chunk_bytes = open_bytes_ + message.bytes() + kHeaderBytes;
    if (!last) {
      LW_RETURN_IF_ERROR(
          reserve_.Ensure(bag_->getSize() + chunk_bytes + chunk_bytes / 16 + IndexBytes()));
    }
    bag_->write(message.topic, message.time, *message.message, message.header);
    bytes_ = bag_->getSize();
    open_bytes_ = chunk_bytes;
    ++open_messages_;
    if (open_bytes_ > kChunkBytes) CountChunk();
    return Status();
  } catch (const std::exception& error) {  // rosbag's
    return GiveUp(error.what());
  }
}

void BagFile::CountChunk() {
  ++chunks_;
  open_bytes_ = open_messages_ = 0;
}

Status BagFile::GiveUp(const std::string& why) {
  // Its destructor would write again, and end the process where that fails: better it is left open.
  (void)bag_.release();
  return Internal("cannot write " + active_path_.string() + " (" + why +
                  "); rosbag reindex makes it readable");
}

Status BagFile::Flush() {
  if (bag_ == nullptr || open_messages_ == 0) return Status();
  try {
    // Told a size of chunks, a bag ends the one that is open.
    bag_->setChunkThreshold(kChunkBytes);
    CountChunk();
    return Status();
  } catch (const std::exception& error) {  // rosbag's
    return GiveUp(error.what());
  }
}

Status BagFile::Finish() {
  if (bag_ == nullptr) return Internal(active_path_.string() + " was given up");
  try {
    bag_->close();
    bag_.reset();
  } catch (const std::exception& error) {  // rosbag's
    return GiveUp(error.what());
  }
  LW_RETURN_IF_ERROR(reserve_.Release());
  reserve_.Close();
  std::error_code error;
  bytes_ = fs::file_size(active_path_, error);
  return RenameFile(active_path_, path_);
}

}  // namespace latticeworld
