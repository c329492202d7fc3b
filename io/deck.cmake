# keyword decks -> Model
target_sources(corpuscle_io PRIVATE deck.cpp)
