from ledger import Ledger
def run(ground, end, random):
    return Ledger("filled_up")
